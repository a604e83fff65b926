#include "stage_tests.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "breccia/homogenisation/test_requests.hpp"
#include "breccia/virtual_test/dynamic_test_state.hpp"
#include "breccia/virtual_test/quasistatic_test_state.hpp"
#include "breccia/viscoelasticity/fit.hpp"

#include "field_records_state.hpp"
#include "named_errors.hpp"

namespace breccia {
namespace {

TestGrid grid_of(const StageGrid& grid) {
  return TestGrid(grid.discretisation.grid().columns());
}

Checkpoint* pointer_to(std::optional<Checkpoint>& checkpoint) {
  return checkpoint ? &*checkpoint : nullptr;
}

/// Passes the fields of a test, which are large, to the sink, and saves the state of the finished test. The fields of a
/// test that an earlier run had finished are already written.
template <class Result>
void hand_over_fields(const StageGrid& grid, Result& found, std::optional<Checkpoint>& checkpoint, StudySink& sink,
                      TestResult& result) {
  if (checkpoint && checkpoint->is_finished()) {
    result.field_files = read_field_records(*checkpoint->earlier());
    return;
  }
  result.fields = std::exchange(found.fields, {});
  if (auto files = sink.fields(*grid.stage, result.id, grid.discretisation, result.fields)) {
    result.field_files = std::move(*files);
    result.fields.clear();
  }
  if (!checkpoint) return;
  checkpoint->finish([&](StateWriter& state) {
    save_result(state, found);
    save(state, result.field_files);
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
                                        std::vector<Moduli> matrix_moduli, Boundary boundary,
                                        const StudyObserver& observer, StudySink& sink) {
  const auto& stage = *grid.stage;
  const auto name = fmt::format("{}, {} cells, quasi-static", bound_of(boundary), name_of(grid_of(grid)));
  auto checkpoint = sink.quasistatic_checkpoint(stage, boundary, grid_of(grid));
  auto test = make_quasistatic_test(*grid.study, stage, matrix, grid.discretisation, boundary, grid.threads);
  test.matrix_moduli = std::move(matrix_moduli);
  auto found = name_errors(fmt::format("{} {}", stage.name, name), [&] {
    // The first elastic solution may take long.
    if (observer.progress) observer.progress(stage, name, 0.0, "begun");
    return run_quasistatic_test(
        test,
        [&](const std::string& details, double share) {
          if (observer.progress) observer.progress(stage, name, share, details);
        },
        pointer_to(checkpoint));
  });
  std::vector<TestResult> results;
  for (const auto& response : found.responses) {
    results.push_back({.id = {response.load, boundary, Method::quasistatic, grid_of(grid)}});
  }
  hand_over_fields(grid, found, checkpoint, sink, results.front());
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
  const auto name =
      fmt::format("{}, {}, {} cells, dynamic", name_of(load), bound_of(boundary), name_of(result.id.grid));
  std::size_t number = 0;
  DynamicObserver follow;
  follow.progress = [&](const DynamicProgress& progress) {
    if (!observer.progress) return;
    observer.progress(stage, name, progress.share,
                      fmt::format("time domain {} at {:.3g} s, {:.0f} million points x steps/s", progress.domain + 1,
                                  progress.time, progress.point_steps_per_second / 1e6));
  };
  follow.finished = [&](const TimeDomain& domain) {
    sink.domain_finished(stage, result.id, ++number, domain);
    if (observer.domain_finished) observer.domain_finished(stage, result.id, domain);
  };
  const auto test = make_dynamic_test(*grid.study, stage, matrix, grid.discretisation, boundary, load, grid.threads);
  auto checkpoint = sink.dynamic_checkpoint(stage, result.id);
  auto found = name_errors(fmt::format("{} {}", stage.name, name),
                           [&] { return run_dynamic_test(test, follow, pointer_to(checkpoint)); });
  hand_over_fields(grid, found, checkpoint, sink, result);
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
