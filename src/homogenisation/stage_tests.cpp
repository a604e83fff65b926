#include "stage_tests.hpp"

#include <utility>

#include <fmt/format.h>

#include "breccia/checkpoint/checkpoint.hpp"
#include "breccia/homogenisation/test_requests.hpp"
#include "breccia/study/chain.hpp"
#include "breccia/virtual_test/dynamic_test_state.hpp"
#include "breccia/virtual_test/quasistatic_test_state.hpp"
#include "breccia/viscoelasticity/fit.hpp"

#include "field_times_state.hpp"
#include "named_errors.hpp"

namespace breccia {
namespace {

TestGrid grid_of(const StageGrid& grid) {
  return TestGrid(grid.discretisation.grid().columns());
}

/// Gives the fields of a test, which are large, to the sink, and leaves the state of the finished test. The sink of an
/// earlier run that had finished the test has taken its fields already.
template <class Result>
void hand_over_fields(const StageGrid& grid, Result& found, Checkpoint* checkpoint, StudySink& sink,
                      TestResult& result) {
  if (checkpoint != nullptr && checkpoint->is_finished()) {
    sink.fields_taken_before(*grid.stage, result.id, read_field_times(*checkpoint->earlier()));
    return;
  }
  result.fields = std::exchange(found.fields, {});
  std::vector<double> times_taken;
  if (sink.take_fields(*grid.stage, result.id, grid.discretisation, result.fields)) {
    for (const auto& [time, fields] : result.fields) times_taken.push_back(time);
    result.fields.clear();
  }
  if (checkpoint == nullptr) return;
  checkpoint->finish([&](StateWriter& state) {
    save_result(state, found);
    save_field_times(state, times_taken);
  });
}

}  // namespace

PronySeries fitted(const Curve& curve) {
  std::vector<double> times, moduli;
  for (const auto& [time, modulus] : curve) {
    times.push_back(time);
    moduli.push_back(modulus);
  }
  return fit_relaxation(times, moduli).series;
}

std::vector<TestResult> run_quasistatic(const StageGrid& grid, const Material& matrix,
                                        std::vector<std::vector<Moduli>> relaxation, Boundary boundary,
                                        const StudyObserver& observer, StudySink& sink) {
  const auto& stage = *grid.stage;
  const TestId first{loads_of(*grid.study, stage).front(), boundary, Method::quasistatic, grid_of(grid)};
  const auto checkpoint = sink.test_checkpoint(stage, first);
  auto test = make_quasistatic_test(*grid.study, stage, matrix, grid.discretisation, boundary, grid.threads);
  test.relaxation = std::move(relaxation);
  auto found = name_errors(fmt::format("{} {}", stage.name, calculation_of(first)), [&] {
    // The first elastic solution may take long.
    if (observer.progress) observer.progress(stage, first, 0.0, "begun");
    return run_quasistatic_test(
        test,
        [&](const std::string& details, double share) {
          if (observer.progress) observer.progress(stage, first, share, details);
        },
        checkpoint.get());
  });
  std::vector<TestResult> results;
  for (const auto& response : found.responses) {
    results.push_back({.id = {response.load, boundary, Method::quasistatic, grid_of(grid)}});
  }
  hand_over_fields(grid, found, checkpoint.get(), sink, results.front());
  for (std::size_t i = 0; i < results.size(); ++i) {
    auto& response = found.responses[i];
    results[i].modulus = std::exchange(response.modulus, {});
    results[i].compliance = std::exchange(response.compliance, {});
    results[i].series = response.series;
    results[i].record = QuasistaticRecord{std::move(response), found.effort, found.seconds};
  }
  return results;
}

TestResult run_dynamic(const StageGrid& grid, const Material& matrix, Boundary boundary, Load load,
                       const StudyObserver& observer, StudySink& sink) {
  const auto& stage = *grid.stage;
  TestResult result{.id = {load, boundary, Method::dynamic, grid_of(grid)}};
  std::size_t number = 0;
  DynamicObserver follow;
  follow.progress = [&](const DynamicProgress& progress) {
    if (!observer.progress) return;
    observer.progress(stage, result.id, progress.share,
                      fmt::format("time domain {} at {:.3g} s, {:.0f} million points x steps/s", progress.domain + 1,
                                  progress.time, progress.point_steps_per_second / 1e6));
  };
  follow.finished = [&](const TimeDomain& domain) {
    sink.domain_finished(stage, result.id, ++number, domain);
    if (observer.domain_finished) observer.domain_finished(stage, result.id, domain);
  };
  const auto test = make_dynamic_test(*grid.study, stage, matrix, grid.discretisation, boundary, load, grid.threads);
  const auto checkpoint = sink.test_checkpoint(stage, result.id);
  auto found = name_errors(fmt::format("{} {}", stage.name, calculation_of(result.id)),
                           [&] { return run_dynamic_test(test, follow, checkpoint.get()); });
  hand_over_fields(grid, found, checkpoint.get(), sink, result);
  result.modulus = std::exchange(found.curve, {});
  result.compliance = std::exchange(found.compliance, {});
  result.series = fitted(result.modulus);
  result.record = std::move(found);
  return result;
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
        "or another ramp may reduce the difference",
        stage.name, name_of(test.id.load), bound_of(test.id.boundary), 100.0 * mismatch, window.begin, window.end));
  }
  return warnings;
}

}  // namespace breccia
