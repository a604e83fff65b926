#include "dynamics/dynamic_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/cell_shape.hpp"

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

/// Largest eigenvalue of M^-1 K of a single cell, times the squared cell side [m^2/s^2]: the side leaves the masses
/// with its power dim and the stiffness with its power dim - 2.
template <int dim>
double largest_cell_eigenvalue(const CellPhases<dim>& cell, const std::vector<Material>& materials,
                               Volumetric volumetric) {
  using Shape = CellShape<dim>;
  typename Shape::PointModuli moduli{};
  typename Shape::Values mass = Shape::Values::Zero();
  for (int p = 0; p < Shape::points; ++p) {
    const auto phase = cell[static_cast<std::size_t>(p)];
    if (phase == no_phase) continue;
    const auto& material = materials[phase];
    moduli[static_cast<std::size_t>(p)] = {material.bulk.unrelaxed(), material.shear.unrelaxed()};
    const auto weights = Shape::weights(p);
    for (int node = 0; node < Shape::nodes; ++node) {
      mass.template segment<dim>(dim * node).array() +=
          Shape::point_volume * material.density * weights[static_cast<std::size_t>(node)];
    }
  }
  const typename Shape::Values scale = mass.cwiseSqrt().cwiseInverse();
  const typename Shape::Stiffness scaled =
      scale.asDiagonal() * Shape::stiffness(moduli, volumetric) * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<typename Shape::Stiffness>(scaled, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

template <int dim>
void require_complete(const Discretisation<dim>& discretisation, const std::vector<Material>& materials) {
  require_phases("dynamic run", discretisation, materials.size());
  for (const auto& material : materials) {
    if (is_void(material)) continue;
    if (!(material.density > 0.0) || !(material.bulk.unrelaxed() + material.shear.unrelaxed() > 0.0)) {
      throw InputError(fmt::format("dynamic run: material '{}' has no density or no stiffness", material.name));
    }
  }
}

}  // namespace

template <int dim>
double stable_time_step(const Discretisation<dim>& discretisation, const std::vector<Material>& materials,
                        Volumetric volumetric, double mass_scaling) {
  require_complete(discretisation, materials);
  if (!(mass_scaling > 0.0)) {
    throw InputError(fmt::format("dynamic run: a mass scaling factor of {} is not positive", mass_scaling));
  }
  const std::set<CellPhases<dim>> kinds(discretisation.cells().begin(), discretisation.cells().end());
  double largest = 0.0;
  for (const auto& kind : kinds) {
    const auto is_empty = [&](PhaseIndex phase) { return phase == no_phase || is_void(materials[phase]); };
    if (std::ranges::all_of(kind, is_empty)) continue;
    largest = std::max(largest, largest_cell_eigenvalue<dim>(kind, materials, volumetric));
  }
  if (!(largest > 0.0)) throw InputError("dynamic run: no cell has a point");
  return 2.0 * discretisation.grid().cell_side * std::sqrt(mass_scaling / largest);
}

template <int dim>
void require_stable(const DynamicProblem<dim>& problem) {
  if (problem.volumetric == Volumetric::standard && !problem.discretisation.mixtures().empty()) {
    throw InputError("dynamic run: expected averaged volumetric strains, which mixed cells have");
  }
  const double limit =
      stable_time_step(problem.discretisation, problem.materials, problem.volumetric, problem.mass_scaling);
  if (!(problem.time_step > 0.0 && problem.time_step <= limit)) {
    throw InputError(
        fmt::format("dynamic run: a time step of {} s is not in (0, {}] s, the range in which it is stable",
                    problem.time_step, limit));
  }
}

template double stable_time_step(const Discretisation<2>&, const std::vector<Material>&, Volumetric, double);
template void require_stable(const DynamicProblem<2>&);
template double stable_time_step(const Discretisation<3>&, const std::vector<Material>&, Volumetric, double);
template void require_stable(const DynamicProblem<3>&);

}  // namespace breccia
