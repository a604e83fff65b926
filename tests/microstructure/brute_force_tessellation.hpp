#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "breccia/microstructure/index.hpp"
#include "breccia/microstructure/laguerre_sites.hpp"

#include "microstructure/uniform.hpp"

namespace breccia::test {

/// What the definition says of a place.
struct DefinedPlace {
  std::size_t site = 0;  // with the least q = |x - c|^2 - w
  double depth = std::numeric_limits<double>::infinity();
};

/// The definition itself: all images of all sites up to two boxes away, and the walls.
template <int dim>
DefinedPlace defined_place(const LaguerreSites<dim>& sites, double film, const Vector<dim>& place) {
  struct Image {
    Vector<dim> position;
    double power;
  };
  const int copies = sites.walls == Walls::periodic ? 2 : 0;
  Index<dim> first, end;
  first.fill(-copies);
  end.fill(copies + 1);
  std::vector<Image> images;
  DefinedPlace result;
  std::size_t nearest = 0;
  for (std::size_t site = 0; site < sites.sites.size(); ++site) {
    for_each_index(first, end, [&](const Index<dim>& copy) {
      Image image{sites.sites[site].position, -sites.sites[site].weight};
      for (std::size_t axis = 0; axis < place.size(); ++axis) {
        image.position[axis] += copy[axis] * sites.side;
        image.power += (place[axis] - image.position[axis]) * (place[axis] - image.position[axis]);
      }
      images.push_back(image);
      if (image.power < images[nearest].power) {
        nearest = images.size() - 1;
        result.site = site;
      }
    });
  }
  for (const Image& other : images) {
    if (&other == &images[nearest]) continue;
    double square = 0.0;
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      const double apart = other.position[axis] - images[nearest].position[axis];
      square += apart * apart;
    }
    const double distance = (other.power - images[nearest].power) / (2.0 * std::sqrt(square));
    result.depth = std::min(result.depth, distance - 0.5 * film);
  }
  if (sites.walls == Walls::hard) {
    for (const double x : place) result.depth = std::min(result.depth, std::min(x, sites.side - x) - 0.5 * film);
  }
  return result;
}

/// Random places in the box [0, side]^dim.
template <int dim>
std::vector<Vector<dim>> random_places(std::size_t count, double side, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::vector<Vector<dim>> places(count);
  for (auto& place : places) {
    for (double& x : place) x = side * uniform(engine);
  }
  return places;
}

/// Diameters from 1 to `ratio`, evenly spread in the logarithm.
inline std::vector<double> diameters_of_ratio(std::size_t count, double ratio) {
  std::vector<double> diameters;
  for (std::size_t k = 0; k < count; ++k) {
    diameters.push_back(std::pow(ratio, static_cast<double>(k) / static_cast<double>(count - 1)));
  }
  return diameters;
}

}  // namespace breccia::test
