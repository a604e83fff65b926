#include "homogenisation/plan/plan_remarks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "homogenisation/plan/cell_time.hpp"
#include "homogenisation/plan/expected_snapshots.hpp"
#include "homogenisation/staging.hpp"
#include "io/display.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

/// The time of the quasi-static tests of a stage on all grids [s].
double time_of_tests(const Study& study, const Stage& stage) {
  double seconds = 0.0;
  for (const int cells : stage.grids()) {
    for (const auto boundary : study.tests.boundaries) seconds += quasistatic_time(study, stage, boundary, cells);
  }
  return seconds;
}

std::optional<std::string> remark_on_range(const Study& study, const Stage& stage) {
  constexpr double far_less = 3.0, long_time = 120.0;
  if (study.tests.quasistatic.range != SampledRange::matrix) return std::nullopt;
  auto of_times = study;
  of_times.tests.quasistatic.range = SampledRange::times;
  const double all = time_of_tests(study, stage), some = time_of_tests(of_times, stage);
  if (all < long_time || all < far_less * some) return std::nullopt;
  return fmt::format(
      "tests.quasistatic.range = \"times\" takes some {} in place of {}: it solves for what the tests ask for alone, "
      "so that a matrix at another temperature takes a run of its own",
      display_duration(some, 1), display_duration(all, 1));
}

std::optional<std::string> remark_on_rounding(const Study& study, const Stage& stage) {
  // Measured with spheres in cubes: theory, section 10. In the plane no basis has missed its tolerance.
  constexpr double limit = 1e-6;
  if (stage.dimensions() == 2) return std::nullopt;
  double softest = std::numeric_limits<double>::infinity();
  for (const auto& point : expected_path(study, stage)) {
    for (const auto& [bulk, shear] : point.moduli) softest = std::min(softest, shear / bulk);
  }
  if (softest >= limit) return std::nullopt;
  return fmt::format(
      "a shear modulus falls to {:.1g} of the bulk modulus, where rounding may keep the reduced basis from "
      "tests.quasistatic.tolerance; the error that it reaches is printed and is part of that of the modulus",
      softest);
}

/// Diameters [m] between which the particles of a wide distribution make stages of equal ratios, from the smallest to
/// the largest.
std::vector<double> bounds_of_stages(const DiameterRange& sizes) {
  constexpr double most_in_a_stage = 8.0;
  const double ratio = sizes.largest / sizes.smallest;
  const double stages = std::ceil(std::log(ratio) / std::log(most_in_a_stage));
  std::vector<double> bounds;
  for (double below = 0.0; below <= stages; below += 1.0) {
    bounds.push_back(sizes.smallest * std::pow(ratio, below / stages));
  }
  return bounds;
}

bool has_particles_in_all(const SizeDistribution& sizes, const std::vector<double>& bounds) {
  const auto has_none = [&sizes](double from, double to) { return !(sizes.cumulative(to) > sizes.cumulative(from)); };
  return std::ranges::adjacent_find(bounds, has_none) == bounds.end();
}

/// Advice to divide sizes between stages where they are so wide that the cells do not resolve the smallest particles.
std::optional<std::string> remark_on_sizes(const Stage& stage) {
  constexpr double wide = 12.0, resolved = 4.0;
  if (stage.fillers.size() != 1 || !stage.fillers.front().fraction || stage.has_grains()) return std::nullopt;
  const auto& filler = stage.fillers.front();
  const auto sizes = diameters_of(filler);
  const auto distribution = distribution_of(filler);
  if (!sizes || !distribution || sizes->largest < wide * sizes->smallest) return std::nullopt;
  const double cells_across = sizes->smallest / stage.side * stage.cells;
  const auto bounds = bounds_of_stages(*sizes);
  if (cells_across >= resolved || !has_particles_in_all(*distribution, bounds)) return std::nullopt;
  std::vector<std::string> stages;
  for (const auto& part : divide_into_stages(*distribution, bounds, *filler.fraction)) {
    stages.push_back(fmt::format("{} to {} with fraction = {:.3g}", display(part.smallest, "m"),
                                 display(part.largest, "m"), part.fraction));
  }
  return fmt::format(
      "its sizes span {:.0f} to 1, and the smallest particle is {:.2g} cells wide; stages, each the matrix of the "
      "next, "
      "take far fewer cells: {}; a stage takes smaller particles as uniform, an error of up to tens of per cent where "
      "sizes touch (docs/limitations.md, Separation of sizes)",
      sizes->largest / sizes->smallest, cells_across, fmt::join(stages, ", then "));
}

}  // namespace

std::vector<std::string> remarks_on_tests(const Study& study, const Stage& stage) {
  std::vector<std::string> remarks;
  if (auto remark = remark_on_sizes(stage)) remarks.push_back(*std::move(remark));
  const bool is_quasistatic = std::ranges::count(study.tests.methods, Method::quasistatic) > 0;
  if (!is_quasistatic || study.tests.quasistatic.solver != Solver::reduced) return remarks;
  for (const auto& remark : {remark_on_range(study, stage), remark_on_rounding(study, stage)}) {
    if (remark) remarks.push_back(*remark);
  }
  return remarks;
}

}  // namespace breccia
