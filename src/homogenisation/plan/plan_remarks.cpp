#include "homogenisation/plan/plan_remarks.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "homogenisation/plan/cell_time.hpp"
#include "homogenisation/plan/expected_snapshots.hpp"
#include "io/display.hpp"

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

}  // namespace

std::vector<std::string> remarks_on_tests(const Study& study, const Stage& stage) {
  std::vector<std::string> remarks;
  const bool is_quasistatic = std::ranges::count(study.tests.methods, Method::quasistatic) > 0;
  if (!is_quasistatic || study.tests.quasistatic.solver != Solver::reduced) return remarks;
  for (const auto& remark : {remark_on_range(study, stage), remark_on_rounding(study, stage)}) {
    if (remark) remarks.push_back(*remark);
  }
  return remarks;
}

}  // namespace breccia
