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

/// A tessellation with films by its definition, evaluated site by site.
template <int dim>
class DefinedTessellation {
 public:
  /// Takes images of the sites up to `boxes` boxes away.
  DefinedTessellation(const LaguerreSites<dim>& sites, double film, int boxes)
      : side_(sites.side), walls_(sites.walls), film_(film) {
    if (walls_ == Walls::hard) boxes = 0;
    Index<dim> first, end;
    first.fill(-boxes);
    end.fill(boxes + 1);
    for (std::size_t site = 0; site < sites.sites.size(); ++site) {
      for_each_index(first, end, [&](const Index<dim>& box) {
        Image image{site, sites.sites[site].position, sites.sites[site].weight};
        for (std::size_t axis = 0; axis < dim; ++axis) image.position[axis] += box[axis] * side_;
        images_.push_back(image);
      });
    }
  }

  struct Place {
    std::size_t site;  // site with the least q = |x - c|^2 - w
    double depth;      // depth, the least (q' - q) / (2 |c' - c|) - t/2, or that to a wall
  };
  [[nodiscard]] Place at(const Vector<dim>& point) const {
    std::vector<double> powers;
    for (const Image& image : images_) powers.push_back(squared_distance(point, image.position) - image.weight);
    const auto nearest = static_cast<std::size_t>(std::ranges::min_element(powers) - powers.begin());
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < images_.size(); ++other) {
      if (other == nearest) continue;
      const double apart = std::sqrt(squared_distance(images_[other].position, images_[nearest].position));
      distance = std::min(distance, (powers[other] - powers[nearest]) / (2.0 * apart));
    }
    if (walls_ == Walls::hard) {
      for (const double x : point) distance = std::min(distance, std::min(x, side_ - x));
    }
    return {images_[nearest].site, distance - 0.5 * film_};
  }

 private:
  struct Image {
    std::size_t site;
    Vector<dim> position;
    double weight;
  };
  static double squared_distance(const Vector<dim>& a, const Vector<dim>& b) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < dim; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return sum;
  }

  double side_;
  Walls walls_;
  double film_;
  std::vector<Image> images_;
};

/// Random points in the box [0, side]^dim.
template <int dim>
std::vector<Vector<dim>> random_points(std::size_t count, double side, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::vector<Vector<dim>> points(count);
  for (auto& point : points) {
    for (double& x : point) x = side * uniform(engine);
  }
  return points;
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
