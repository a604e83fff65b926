#include "breccia/homogenisation/quasistatic_time.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include "breccia/homogenisation/expected_snapshots.hpp"
#include "breccia/homogenisation/memory.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/homogenisation/test_requests.hpp"
#include "breccia/homogenisation/varying_phases.hpp"
#include "breccia/quasistatic/carson_path.hpp"
#include "breccia/study/chain.hpp"
#include "breccia/study/test_rules.hpp"

namespace breccia {
namespace {

/// Solutions of a run that steps through time, with fine and with coarse steps.
double steps_of(const Tests& tests) {
  constexpr double warm_up_decades = 3.0, fine_and_coarse = 1.5;
  const double decades = warm_up_decades + std::log10(tests.last_time / tests.first_time);
  return fine_and_coarse * decades * tests.quasistatic.steps_per_decade;
}

/// On substructures, or by sparse factors.
double time_with_factors(const Study& study, const Stage& stage, double unknowns, bool is_direct) {
  const auto loads = static_cast<double>(loads_of(study, stage).size());
  const double factorisation = is_direct ? 2.2e-6 : 1.2e-6, solve = is_direct ? 0.8e-6 : 1.5e-6;
  if (study.tests.quasistatic.solver == Solver::reduced) {
    return expected_snapshots(study.tests, stage) * unknowns * (factorisation + solve * loads);
  }
  return steps_of(study.tests) * unknowns * (factorisation + solve) * loads;
}

/// What conjugate gradients on a cube take by fast transforms (docs/three-dimensions.md, "Cost").
struct IterationsOfCube {
  double of_root;  ///< iterations over the root of the contrast
  double seconds;  ///< of an iteration, an unknown [s]
};

constexpr IterationsOfCube iterations_under(Boundary boundary) {
  switch (boundary) {
    case Boundary::periodic:
      return {6.5, 29e-9};
    case Boundary::displacement:
      return {7.0, 30e-9};
    case Boundary::traction:
      return {13.0, 33e-9};
  }
  return {};
}

/// The root of the greatest stiffness of the phases over the least one of the box that preconditions them, which is
/// that of a wave under a periodic boundary and a shear modulus between walls (theory, section 18).
double root_of_contrast(const std::vector<Moduli>& phases, Boundary boundary) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Moduli least = {.bulk = infinite, .shear = infinite}, most = {.bulk = 0.0, .shear = 0.0};
  for (const auto& [bulk, shear] : phases) {
    least = {.bulk = std::min(least.bulk, bulk), .shear = std::min(least.shear, shear)};
    most = {.bulk = std::max(most.bulk, bulk), .shear = std::max(most.shear, shear)};
  }
  const double contrast = boundary == Boundary::periodic ? std::max(most.shear / least.shear, most.bulk / least.bulk)
                                                         : (most.bulk + 4.0 / 3.0 * most.shear) / least.shear;
  return std::sqrt(contrast);
}

/// The moduli of all phases on the path on which the solutions lie.
std::vector<CarsonPoint> path_of(const Study& study, const Stage& stage) {
  const auto materials = materials_of(stage, expected_matrix(study, stage));
  const TimeWindow window = {study.tests.first_time, study.tests.last_time};
  const bool is_whole =
      study.tests.quasistatic.solver == Solver::reduced && study.tests.quasistatic.range == SampledRange::matrix;
  auto path = is_whole ? relaxation_path(materials, window) : carson_path(materials, window);
  const auto is_beyond = [](const CarsonPoint& point) { return std::ranges::any_of(point.moduli, is_like_softer); };
  if (is_whole) path.erase(std::remove_if(std::next(path.begin()), path.end(), is_beyond), path.end());
  return path;
}

double time_of_cube(const Study& study, const Stage& stage, Boundary boundary, double unknowns) {
  const auto path = path_of(study, stage);
  double roots = 0.0;
  for (const auto& point : path) roots += root_of_contrast(point.moduli, boundary);
  const auto [of_root, seconds] = iterations_under(boundary);
  const double solution = of_root * roots / static_cast<double>(path.size()) * seconds;
  // The forces of a part of the stiffness on a displacement.
  constexpr double forces = 50e-9;
  const auto loads = static_cast<double>(loads_of(study, stage).size());
  if (study.tests.quasistatic.solver == Solver::stepping) {
    constexpr double forces_of_step = 14.0;
    return loads * unknowns * steps_of(study.tests) * (solution + forces_of_step * forces);
  }
  // A new vector of the basis takes the products of the forces of its parts with those of all others.
  const double snapshots = std::min(expected_snapshots(study.tests, stage), static_cast<double>(path.size()));
  const double parts = 1.0 + 2.0 * static_cast<double>(varying_phases(study.tests, stage).size());
  constexpr double forces_of_solution = 10.0;
  // A solution for the basis begins with the one that the basis has, and ends where the basis needs no more.
  constexpr double share_of_iterations = 0.8;
  const double evaluations = snapshots * (0.5 * parts * parts * (snapshots + 1.0) + forces_of_solution);
  return loads * unknowns * (snapshots * share_of_iterations * solution + evaluations * forces);
}

}  // namespace

double quasistatic_time(const Study& study, const Stage& stage, Boundary boundary, int cells) {
  const double unknowns = quasistatic_unknowns(stage, cells);
  const bool is_direct =
      study.tests.quasistatic.linear.is_direct(static_cast<std::int64_t>(unknowns), stage.dimensions());
  if (stage.dimensions() == 3 && !is_direct) return time_of_cube(study, stage, boundary, unknowns);
  return time_with_factors(study, stage, unknowns, is_direct);
}

}  // namespace breccia
