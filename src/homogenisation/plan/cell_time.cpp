#include "homogenisation/plan/cell_time.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "discretisation/contrast.hpp"
#include "homogenisation/plan/cell_memory.hpp"
#include "homogenisation/plan/expected_snapshots.hpp"
#include "homogenisation/plan/measured_costs.hpp"
#include "homogenisation/varying_phases.hpp"
#include "study/chain.hpp"

namespace breccia {
namespace {

/// Time of a solution on substructures, or by sparse factors [s]. Mixed cells are eliminated anew for each set of
/// moduli.
double time_with_factors(const Study& study, const Stage& stage, Boundary boundary, int cells, double unknowns,
                         bool is_direct) {
  namespace costs = measured_costs;
  const auto loads = static_cast<double>(solved_loads(study, stage, boundary).size());
  const double size = std::max(1.0, unknowns / costs::unknowns_of_factorisation);
  const double set_up =
      is_direct ? costs::factorisation * std::pow(size, costs::power_of_factorisation) : costs::setup_of_substructures;
  const double solution = (is_direct ? costs::solution_by_factors : costs::solution_on_substructures) +
                          costs::mixed_cells * share_of_mixed_cells(study, stage, cells);
  if (study.tests.quasistatic.solver == Solver::reduced) {
    return expected_snapshots(study, stage) * unknowns * (set_up + solution * loads);
  }
  return expected_steps(study.tests) * unknowns * (set_up + solution) * loads;
}

constexpr measured_costs::IterationsOfCube iterations_under(Boundary boundary) {
  switch (boundary) {
    case Boundary::periodic:
      return measured_costs::periodic_cube;
    case Boundary::displacement:
      return measured_costs::held_cube;
    case Boundary::traction:
      return measured_costs::drawn_cube;
  }
  return {};
}

/// The square root of a contrast: the greatest stiffness of the phases over the least stiffness of the homogeneous box
/// that preconditions them. The latter is that of a wave under a periodic boundary and a shear modulus between walls
/// (theory, section 18).
double root_of_contrast(const std::vector<Moduli>& phases, Boundary boundary) {
  const auto least = least_of_solids(phases);
  Moduli most = {.bulk = 0.0, .shear = 0.0};
  for (const auto& [bulk, shear] : phases) {
    most = {.bulk = std::max(most.bulk, bulk), .shear = std::max(most.shear, shear)};
  }
  const double contrast = boundary == Boundary::periodic ? std::max(most.shear / least.shear, most.bulk / least.bulk)
                                                         : (most.bulk + 4.0 / 3.0 * most.shear) / least.shear;
  return std::sqrt(contrast);
}

/// Time of a solution by conjugate gradients on a cube, for each unknown [s].
double time_of_conjugate_gradients(const Study& study, const Stage& stage, Boundary boundary) {
  const auto path = expected_path(study, stage);
  double roots = 0.0;
  for (const auto& point : path) roots += root_of_contrast(point.moduli, boundary);
  const auto [of_root, seconds] = iterations_under(boundary);
  return of_root * roots / static_cast<double>(path.size()) * seconds;
}

/// Time of a solution on a cube with flow through gaps, for each unknown [s].
double time_of_minimal_residuals(int cells) {
  return measured_costs::iterations_with_flow * std::pow(static_cast<double>(cells), 1.5) *
         measured_costs::seconds_with_flow;
}

double time_of_cube(const Study& study, const Stage& stage, Boundary boundary, int cells, double unknowns) {
  const double solution = is_expected_to_have_flow(study, stage) ? time_of_minimal_residuals(cells)
                                                                 : time_of_conjugate_gradients(study, stage, boundary);
  const auto loads = static_cast<double>(solved_loads(study, stage, boundary).size());
  if (study.tests.quasistatic.solver == Solver::stepping) {
    return loads * unknowns * expected_steps(study.tests) *
           (solution + measured_costs::forces_of_step * measured_costs::forces_of_cube);
  }
  // A new vector of the basis takes the products of the forces of its parts with those of all others.
  const double snapshots = expected_snapshots(study, stage);
  const double parts = 1.0 + 2.0 * static_cast<double>(varying_phases(study.tests, stage).size());
  const double evaluations = snapshots * (0.5 * parts * parts * (snapshots + 1.0) + measured_costs::forces_of_solution);
  return loads * unknowns *
         (snapshots * measured_costs::share_of_iterations * solution + evaluations * measured_costs::forces_of_cube);
}

}  // namespace

double quasistatic_time(const Study& study, const Stage& stage, Boundary boundary, int cells) {
  const double unknowns = quasistatic_unknowns(study, stage, cells);
  const bool is_direct =
      study.tests.quasistatic.linear.is_direct(static_cast<std::int64_t>(unknowns), stage.dimensions());
  if (stage.dimensions() == 3 && !is_direct) {
    const double crystals = stage.has_crystals() ? measured_costs::crystals_in_space : 1.0;
    return crystals * time_of_cube(study, stage, boundary, cells, unknowns);
  }
  const double flow = is_expected_to_have_flow(study, stage) ? measured_costs::flow_in_plane : 1.0;
  return flow * time_with_factors(study, stage, boundary, cells, unknowns, is_direct);
}

double discretisation_time(const Study& study, const Stage& stage, int cells) {
  const bool has_shapes =
      std::ranges::any_of(stage.fillers, [](const Filler& filler) { return filler.shape.has_value(); });
  if (!has_shapes) return 0.0;
  return measured_costs::mixing_of_shapes * share_of_mixed_cells(study, stage, cells) *
         std::pow(static_cast<double>(cells), stage.dimensions());
}

}  // namespace breccia
