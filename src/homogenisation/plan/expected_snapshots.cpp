#include "homogenisation/plan/expected_snapshots.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "homogenisation/plan/measured_costs.hpp"
#include "homogenisation/run/test_requests.hpp"

namespace breccia {
namespace {

/// Decades between the least and the largest shear modulus of each phase on a path, summed over the phases.
double decades_of(const std::vector<CarsonPoint>& path) {
  double decades = 0.0;
  for (std::size_t phase = 0; phase < path.front().moduli.size(); ++phase) {
    const auto shear = [phase](const CarsonPoint& point) { return point.moduli[phase].shear; };
    const auto [least, most] = std::ranges::minmax_element(path, {}, shear);
    if (is_void(least->moduli[phase])) continue;
    decades += std::min(measured_costs::most_decades, std::log10(shear(*most) / shear(*least)));
  }
  return decades;
}

double factor_of(const std::optional<ModulusInterval>& interval) {
  if (!interval) return 1.0;
  return 1.0 + measured_costs::snapshots_of_varied_decade * std::log10(interval->most / interval->least);
}

}  // namespace

std::vector<CarsonPoint> expected_path(const Study& study, const Stage& stage) {
  const auto materials = materials_of(stage, expected_matrix(study, stage));
  const TimeWindow window = {study.tests.first_time, study.tests.last_time};
  const bool is_whole =
      study.tests.quasistatic.solver == Solver::reduced && study.tests.quasistatic.range == SampledRange::matrix;
  auto path = is_whole ? relaxation_path(materials, window) : carson_path(materials, window);
  const auto is_beyond = [](const CarsonPoint& point) { return std::ranges::any_of(point.moduli, is_like_softer); };
  if (is_whole) path.erase(std::remove_if(std::next(path.begin()), path.end(), is_beyond), path.end());
  return path;
}

double expected_snapshots(const Study& study, const Stage& stage) {
  const auto path = expected_path(study, stage);
  double snapshots = measured_costs::snapshots + measured_costs::snapshots_of_decade * decades_of(path);
  if (stage.dimensions() == 3) snapshots *= measured_costs::snapshots_of_cubes;
  snapshots = std::min(snapshots, static_cast<double>(path.size()));
  for (const auto& material : named_materials(stage)) {
    const auto varied = std::ranges::find(study.tests.varied, material.name, &VariedMaterial::name);
    if (varied == study.tests.varied.end()) continue;
    snapshots *= factor_of(varied->shear) * factor_of(varied->bulk);
    if (!varied->others.empty()) snapshots *= measured_costs::snapshots_of_others;
  }
  return snapshots;
}

double expected_steps(const Tests& tests) {
  constexpr double warm_up_decades = 3.0, fine_and_coarse = 1.5;
  const double decades = warm_up_decades + std::log10(tests.last_time / tests.first_time);
  return fine_and_coarse * decades * tests.quasistatic.steps_per_decade;
}

}  // namespace breccia
