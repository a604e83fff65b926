#include "breccia/dynamics/dynamic_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "breccia/discretisation/cell.hpp"
#include "breccia/error.hpp"

namespace breccia {

StrainRamp::StrainRamp(double duration) : duration_(duration) {
  if (!(duration >= 0.0)) throw InputError(fmt::format("strain ramp: a duration of {} s is negative", duration));
}

double StrainRamp::at(double t) const noexcept {
  if (t >= 0.5 * duration_) return 1.0;
  if (t <= -0.5 * duration_) return 0.0;
  const double x = t / duration_;
  return 0.5 + x + std::sin(2.0 * std::numbers::pi * x) / (2.0 * std::numbers::pi);
}

namespace {

constexpr CellMaterials empty_cell = {no_material, no_material, no_material, no_material};

/// Largest eigenvalue of M^-1 K of a single cell, times the squared cell side [m^2/s^2].
double largest_cell_eigenvalue(const CellMaterials& cell, const std::vector<Material>& materials,
                               Volumetric volumetric) {
  std::array<Moduli, points_per_cell> moduli{};
  CellVector mass = CellVector::Zero();
  for (int p = 0; p < points_per_cell; ++p) {
    if (cell[static_cast<std::size_t>(p)] == no_material) continue;
    const auto& material = materials[cell[static_cast<std::size_t>(p)]];
    moduli[static_cast<std::size_t>(p)] = {material.bulk.unrelaxed(), material.shear.unrelaxed()};
    const auto weights = node_weights(p);
    for (Eigen::Index node = 0; node < 4; ++node) {
      mass.segment<2>(2 * node).array() += 0.25 * material.density * weights[static_cast<std::size_t>(node)];
    }
  }
  const CellVector scale = mass.cwiseSqrt().cwiseInverse();
  const CellMatrix scaled = scale.asDiagonal() * cell_stiffness(moduli, volumetric) * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<CellMatrix>(scaled, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

void require_complete(const Discretisation& discretisation, const std::vector<Material>& materials) {
  for (const auto& cell : discretisation.cells()) {
    for (const auto material : cell) {
      if (material != no_material && material >= materials.size()) {
        throw InputError(
            fmt::format("dynamic run: a point has material {}, but only {} are given", material, materials.size()));
      }
    }
  }
  for (const auto& material : materials) {
    if (!(material.density > 0.0) || !(material.bulk.unrelaxed() + material.shear.unrelaxed() > 0.0)) {
      throw InputError(fmt::format("dynamic run: material '{}' has no density or no stiffness", material.name));
    }
  }
}

}  // namespace

double stable_time_step(const Discretisation& discretisation, const std::vector<Material>& materials,
                        Volumetric volumetric, double density_factor) {
  require_complete(discretisation, materials);
  const std::set<CellMaterials> kinds(discretisation.cells().begin(), discretisation.cells().end());
  double largest = 0.0;
  for (const auto& kind : kinds) {
    if (kind == empty_cell) continue;
    largest = std::max(largest, largest_cell_eigenvalue(kind, materials, volumetric));
  }
  if (!(largest > 0.0)) throw InputError("dynamic run: no cell has a point");
  return 2.0 * discretisation.grid().cell_side * std::sqrt(density_factor / largest);
}

void require_stable(const DynamicProblem& problem) {
  const double limit =
      stable_time_step(problem.discretisation, problem.materials, problem.volumetric, problem.density_factor);
  if (!(problem.time_step > 0.0) || problem.time_step > limit) {
    throw InputError(
        fmt::format("dynamic run: a time step of {} s is not in (0, {}] s, the range in which it is stable",
                    problem.time_step, limit));
  }
}

}  // namespace breccia
