#include "films/space/shrunk_grains.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia::films {
namespace {

/// A face of the complex as a flat polygon.
struct FlatFace {
  double area;
  Eigen::Vector3d normal;    ///< normal out of the first cell, of length 1
  Eigen::Vector3d centroid;  ///< beside the first cell
};

FlatFace flat(const CellComplex& complex, const SharedFace& face) {
  const auto first = complex.position(face.corners[0]);
  Eigen::Vector3d area = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  double weight = 0.0;
  for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
    const auto a = complex.position(face.corners[i]), b = complex.position(face.corners[i + 1]);
    const Eigen::Vector3d of_triangle = 0.5 * (a - first).cross(b - first);
    area += of_triangle;
    weight += of_triangle.norm();
    moment += of_triangle.norm() / 3.0 * (first + a + b);
  }
  return {area.norm(), area.normalized(), moment / weight};
}

/// Sums for the best scale and shift of a grain by least squares: with the recess mu x - b of a point x of the cell,
/// the sum over its faces of area (n . (mu x - b) - 1/2)^2: at unit thickness each face recedes by half of it.
struct Fit {
  Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
  Eigen::Vector4d wanted = Eigen::Vector4d::Zero();

  void add(const FlatFace& face, const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
    constexpr double recess = 0.5;
    Eigen::Vector4d row;
    row << normal.dot(point), -normal;
    products += face.area * row * row.transpose();
    wanted += face.area * recess * row;
  }
};

/// What a grain of unit thickness of the films loses: mu = 1 - scale and b, relative to the position of its site.
struct Recession {
  double mu;
  Eigen::Vector3d b;
};

Eigen::Vector3d position_of(const Tessellation<3>& tessellation, std::size_t site) {
  const auto& position = tessellation.sites().sites[site].position;
  return Eigen::Vector3d(position[0], position[1], position[2]) / tessellation.side();
}

std::vector<Recession> unit_recessions(const Tessellation<3>& tessellation, const CellComplex& complex) {
  std::vector<Fit> fits(tessellation.size());
  for (const auto& face : complex.faces) {
    const auto& [second, image] = face.second;
    const auto shape = flat(complex, face);
    fits[face.first].add(shape, shape.normal, shape.centroid - position_of(tessellation, face.first));
    const Eigen::Vector3d seen_from_second = shape.centroid - image.cast<double>() - position_of(tessellation, second);
    fits[second].add(shape, -shape.normal, seen_from_second);
  }
  std::vector<Recession> recessions;
  for (const auto& fit : fits) {
    const Eigen::Vector4d solution = fit.products.ldlt().solve(fit.wanted);
    recessions.push_back({solution[0], solution.tail<3>()});
  }
  return recessions;
}

/// The thickness at which the grains fill this fraction, by bisection.
double thickness_of(const std::vector<Recession>& recessions, const std::vector<double>& volumes, double fraction) {
  const auto filled = [&](double thickness) {
    double sum = 0.0;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
      const double scale = std::max(0.0, 1.0 - thickness * recessions[i].mu);
      sum += scale * scale * scale * volumes[i];
    }
    return sum;
  };
  double thin = 0.0, thick = 1.0 / std::ranges::max(recessions, {}, &Recession::mu).mu;
  constexpr int halvings = 200;
  for (int i = 0; i < halvings && thin < thick; ++i) {
    const double middle = std::midpoint(thin, thick);
    if (middle == thin || middle == thick) break;
    (filled(middle) > fraction ? thin : thick) = middle;
  }
  return std::midpoint(thin, thick);
}

/// Throws InputError, with all the sites, when grains have vanished or reach into each other.
void require_films(const CellComplex& complex, const std::vector<ShrunkGrain>& grains, double fraction) {
  constexpr double least_scale = 1e-6;
  std::set<std::size_t> vanished, overlapping;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    if (!(grains[i].scale > least_scale)) vanished.insert(i);
  }
  for (const auto& face : complex.faces) {
    const auto shape = flat(complex, face);
    for (const auto& corner : face.corners) {
      const auto point = complex.position(corner);
      const Eigen::Vector3d film = grains[face.second.cell].place(point, face.second.image) -
                                   grains[face.first].place(point, Eigen::Vector3i::Zero());
      if (film.dot(shape.normal) > 0.0) continue;
      overlapping.insert(face.first);
      overlapping.insert(face.second.cell);
    }
  }
  const auto refuse = [&](const std::set<std::size_t>& sites, const char* what) {
    if (sites.empty()) return;
    throw InputError(
        fmt::format("films: at a fraction of {:.4g} the grains of the sites {} (from 0) {}; a higher "
                    "fraction, or grains of less different sizes, avoid it, and so do cells",
                    fraction, fmt::join(sites, ", "), what));
  };
  refuse(vanished, "vanish in their films");
  refuse(overlapping, "would reach into each other");
}

}  // namespace

std::vector<ShrunkGrain> shrunk_grains(const Tessellation<3>& tessellation, const CellComplex& complex,
                                       double fraction) {
  const auto recessions = unit_recessions(tessellation, complex);
  auto volumes = cell_volumes(tessellation);
  const double box = times_power<3>(1.0, tessellation.side());
  for (double& volume : volumes) volume /= box;
  const double thickness = thickness_of(recessions, volumes, fraction);
  std::vector<ShrunkGrain> grains;
  for (std::size_t i = 0; i < recessions.size(); ++i) {
    // Relative to its site, x is at x - thickness (mu x - b).
    const double loss = thickness * recessions[i].mu;
    grains.push_back({1.0 - loss, loss * position_of(tessellation, i) + thickness * recessions[i].b});
  }
  require_films(complex, grains, fraction);
  return grains;
}

}  // namespace breccia::films
