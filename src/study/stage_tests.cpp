#include "stage_tests.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/experiment/extrapolation.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/viscoelasticity/fit.hpp"

#include "named_errors.hpp"
#include "results.hpp"

namespace breccia {
namespace {

std::vector<Material> materials_of(const Stage& stage) {
  std::vector<Material> materials = {stage.matrix};
  if (stage.filler) materials.push_back(stage.filler->material);
  return materials;
}

/// The series of a curve that a method gives as numbers.
PronySeries fitted(const Curve& curve) {
  constexpr std::size_t fewest = 3;
  if (curve.size() < fewest) return PronySeries(curve.back().modulus);
  std::vector<double> times, moduli;
  for (const auto& [time, modulus] : curve) {
    times.push_back(time);
    moduli.push_back(modulus);
  }
  return fit_relaxation(times, moduli).series;
}

/// The tests that differ from one in their grids alone, by rising number of cells.
std::vector<const TestResult*> same_on_all_grids(const TestResult& one, const std::vector<TestResult>& tests) {
  std::vector<const TestResult*> same;
  for (const auto& test : tests) {
    if (test.load == one.load && test.boundary == one.boundary && test.method == one.method) same.push_back(&test);
  }
  return same;
}

TestResult extrapolate_test(const Stage& stage, const std::vector<const TestResult*>& grids) {
  const auto& finest = *grids.back();
  TestResult result{.load = finest.load, .boundary = finest.boundary, .method = finest.method};
  ExtrapolationRecord record;
  std::vector<double> cell_sides;
  for (const auto* grid : grids) {
    record.cells.push_back(grid->cells);
    cell_sides.push_back(stage.side / grid->cells);
  }
  const auto limit = [&](double time, const auto& value) {
    std::vector<double> values;
    std::ranges::transform(grids, std::back_inserter(values), value);
    const auto extrapolated = extrapolate(cell_sides, values);
    if (extrapolated.value > 0.0) return extrapolated;
    throw NumericalError(
        fmt::format("extrapolation to vanishing cells gives {:.3g} at {:.3g} s: the grids are too "
                    "coarse for a law of first order; take finer ones",
                    extrapolated.value, time));
  };
  for (std::size_t i = 0; i < finest.modulus.size(); ++i) {
    const double time = finest.modulus[i].time;
    const auto [modulus, half_band] = limit(time, [&](const TestResult* grid) { return grid->modulus[i].modulus; });
    result.modulus.push_back({time, modulus});
    record.half_bands.push_back(half_band);
    if (finest.compliance.empty()) continue;
    const auto creep = limit(time, [&](const TestResult* grid) { return grid->compliance[i].compliance; });
    result.compliance.push_back({time, creep.value});
  }
  result.series = fitted(result.modulus);
  result.record = std::move(record);
  return result;
}

}  // namespace

DynamicTest make_dynamic_test(const Study& study, const Stage& stage, const Discretisation& discretisation,
                              Boundary boundary, Load load, int threads) {
  return {.discretisation = discretisation,
          .materials = materials_of(stage),
          .boundary = boundary,
          .load = load,
          .times = {study.tests.first_time, study.tests.last_time},
          .points_per_decade = study.tests.points_per_decade,
          .options = study.tests.dynamic,
          .threads = threads};
}

QuasistaticTest make_quasistatic_test(const Study& study, const Stage& stage, const Discretisation& discretisation,
                                      Boundary boundary) {
  return {.discretisation = discretisation,
          .materials = materials_of(stage),
          .boundary = boundary,
          .loads = study.tests.loads,
          .times = {study.tests.first_time, study.tests.last_time},
          .points_per_decade = study.tests.points_per_decade,
          .options = study.tests.quasistatic};
}

std::vector<TestResult> run_quasistatic(const StageGrid& grid, Boundary boundary, const StudyObserver& observer) {
  const auto& stage = *grid.stage;
  const int cells = grid.discretisation.grid().columns;
  const auto name = fmt::format("{}, {} cells, quasi-static", bound_of(boundary), cells);
  const auto test = make_quasistatic_test(*grid.study, stage, grid.discretisation, boundary);
  auto done = name_errors(fmt::format("{} {}", stage.name, name), [&] {
    return run_quasistatic_test(test, [&](const std::string& details, double share) {
      if (observer.progress) observer.progress(stage, name, share, details);
    });
  });
  std::vector<TestResult> results;
  for (auto& response : done.responses) {
    TestResult result{.load = response.load, .boundary = boundary, .method = Method::quasistatic, .cells = cells};
    result.modulus = std::exchange(response.modulus, {});
    result.compliance = std::exchange(response.compliance, {});
    result.series = response.series;
    result.record = QuasistaticRecord{std::move(response), done.effort, done.seconds};
    results.push_back(std::move(result));
  }
  return results;
}

TestResult run_dynamic(const StageGrid& grid, Boundary boundary, Load load, const StudyObserver& observer,
                       PointFields& fields) {
  const auto& stage = *grid.stage;
  const int cells = grid.discretisation.grid().columns;
  const auto name = fmt::format("{}, {}, {} cells, dynamic", name_of(load), bound_of(boundary), cells);
  std::size_t number = 0;
  DynamicObserver follow;
  follow.progress = [&](const DynamicProgress& progress) {
    if (!observer.progress) return;
    observer.progress(stage, name, progress.share,
                      fmt::format("time domain {} at {:.3g} s, {:.0f} million points x steps/s", progress.domain + 1,
                                  progress.time, progress.point_steps_per_second / 1e6));
  };
  follow.finished = [&](const TimeDomain& domain) {
    if (parallel::rank() == 0) {
      write_history(grid.directory, *grid.study, stage, {boundary, load, cells, ++number}, domain);
    }
    if (observer.domain_finished) observer.domain_finished(stage, boundary, load, domain);
  };
  const auto test = make_dynamic_test(*grid.study, stage, grid.discretisation, boundary, load, grid.threads);
  auto done = name_errors(fmt::format("{} {}", stage.name, name), [&] { return run_dynamic_test(test, follow); });
  fields = std::exchange(done.fields, {});
  TestResult result{.load = load, .boundary = boundary, .method = Method::dynamic, .cells = cells};
  result.modulus = std::exchange(done.curve, {});
  result.compliance = std::exchange(done.compliance, {});
  result.series = fitted(result.modulus);
  result.record = std::move(done);
  return result;
}

std::vector<TestResult> extrapolate_tests(const Stage& stage, const std::vector<TestResult>& tests) {
  std::vector<TestResult> extrapolated;
  if (stage.coarser_cells.empty()) return extrapolated;
  for (const auto& test : tests) {
    if (test.cells != stage.cells) continue;
    const auto grids = same_on_all_grids(test, tests);
    const auto name =
        fmt::format("{} {} {} {}", stage.name, name_of(test.load), bound_of(test.boundary), name_of(test.method));
    extrapolated.push_back(name_errors(name, [&] { return extrapolate_test(stage, grids); }));
  }
  return extrapolated;
}

std::vector<std::string> warnings_of(const Stage& stage, const TestResult& test) {
  constexpr double tolerance = 0.03;
  std::vector<std::string> warnings;
  const auto* dynamic = std::get_if<DynamicTestResult>(&test.record);
  if (dynamic == nullptr) return warnings;
  for (const auto& [window, mismatch] : dynamic->overlaps) {
    if (mismatch <= tolerance) continue;
    warnings.push_back(fmt::format(
        "{} {}, {}: two time domains differ by {:.1f} % between {:.3g} and {:.3g} s; smaller density factors "
        "or another ramp bring them together",
        stage.name, name_of(test.load), bound_of(test.boundary), 100.0 * mismatch, window.begin, window.end));
  }
  return warnings;
}

}  // namespace breccia
