#include "homogenisation/run/stage_tests.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "breccia/viscoelasticity/fit.hpp"

#include "checkpoint/checkpoint.hpp"
#include "homogenisation/dynamic_warnings.hpp"
#include "homogenisation/run/field_times_state.hpp"
#include "homogenisation/run/named_errors.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "study/chain.hpp"
#include "virtual_test/dynamic_test_state.hpp"
#include "virtual_test/quasistatic_test_state.hpp"

namespace breccia {
namespace {

TestGrid grid_of(const StageGrid& grid) {
  return TestGrid(cells_along(grid.cells.discretisation));
}

/// Ends a test: its fields, which are large, go to the sink, and its state to the checkpoint. For a test that an
/// earlier run has finished, both are stored already.
template <class Found>
void finish(const Stage& stage, const Found& found, TestResult& result, Checkpoint* checkpoint, StudySink& sink) {
  if (checkpoint != nullptr && checkpoint->is_finished()) {
    sink.happened(FieldsStoredBefore{stage, result.id, read_field_times(*checkpoint->earlier())});
    return;
  }
  std::vector<double> times_stored;
  if (sink.store_fields(stage, result.id, result.fields)) times_stored = times_of(std::exchange(result.fields, {}));
  if (checkpoint == nullptr) return;
  checkpoint->finish([&](StateWriter& state) {
    save_result(state, found);
    save_field_times(state, times_stored);
  });
}

/// The name of a test for errors and the progress: "fine traction, 50 cells per side, quasi-static".
std::string name_of(const Stage& stage, const TestId& test) {
  return fmt::format("{} {}", stage.name, calculation_of(test));
}

/// Passes the progress of a calculation of this name to the sink.
ProgressObserver progress_to(StudySink& sink, const std::string& what) {
  return [&sink, what](const Progress& of_test) { sink.progress({what, of_test.share, of_test.details}); };
}

/// Runs a quasi-static test of all loads, with its checkpoint. Returns a result for each load; the first one has the
/// fields.
std::vector<TestResult> run_all_loads(const Stage& stage, const QuasistaticTest& test, TestGrid grid, StudySink& sink) {
  const auto id_of = [&](Load load) { return TestId{load, test.boundary, Method::quasistatic, grid}; };
  const auto first = id_of(test.loads.front());
  const auto checkpoint = sink.test_checkpoint(stage, first);
  const auto name = name_of(stage, first);
  auto found = name_errors(name, [&] {
    sink.progress({.what = name, .details = "begun"});  // the first elastic solution may take long
    return run_quasistatic_test(test, progress_to(sink, name), checkpoint.get());
  });
  std::vector<TestResult> results;
  for (const auto& response : found.responses) results.push_back({.id = id_of(response.load)});
  results.front().fields = std::exchange(found.fields, {});
  finish(stage, found, results.front(), checkpoint.get(), sink);
  for (std::size_t i = 0; i < results.size(); ++i) {
    auto& response = found.responses[i];
    results[i].modulus = std::exchange(response.modulus, {});
    results[i].compliance = std::exchange(response.compliance, {});
    results[i].series = std::move(response.series);
    results[i].error_estimate = response.error_estimate;
    results[i].seconds = found.seconds;
    results[i].record = QuasistaticRecord{std::move(response.reduced), response.fit_error, found.effort};
  }
  return results;
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
                                        StudySink& sink) {
  auto test = make_quasistatic_test(*grid.study, *grid.stage, matrix, grid.cells, boundary, grid.threads);
  test.relaxation = std::move(relaxation);
  return run_all_loads(*grid.stage, test, grid_of(grid), sink);
}

std::vector<TestResult> run_films(const StageFilms& films, const Material& matrix,
                                  std::vector<std::vector<Moduli>> relaxation, Boundary boundary, StudySink& sink) {
  auto test = make_film_test(*films.study, *films.stage, matrix, *films.grains, boundary, films.threads);
  test.relaxation = std::move(relaxation);
  return run_all_loads(*films.stage, test, TestGrid::films(), sink);
}

TestResult run_dynamic(const StageGrid& grid, const Material& matrix, Boundary boundary, Load load, StudySink& sink) {
  const auto& stage = *grid.stage;
  TestResult result{.id = {load, boundary, Method::dynamic, grid_of(grid)}};
  const auto name = name_of(stage, result.id);
  std::size_t number = 0;
  const auto finished = [&](const TimeDomain& domain) {
    sink.happened(DomainFinished{stage, result.id, ++number, domain});
  };
  const auto checkpoint = sink.test_checkpoint(stage, result.id);
  auto found = std::visit(
      [&](const auto& discretisation) {
        const auto test = make_dynamic_test(*grid.study, stage, matrix, discretisation, boundary, load, grid.threads);
        return name_errors(name,
                           [&] { return run_dynamic_test(test, progress_to(sink, name), finished, checkpoint.get()); });
      },
      grid.cells.discretisation);
  result.fields = std::exchange(found.fields, {});
  finish(stage, found, result, checkpoint.get(), sink);
  result.modulus = std::exchange(found.curve, {});
  result.compliance = std::exchange(found.compliance, {});
  result.series = fitted(result.modulus);
  result.seconds = 0.0;
  for (const auto& domain : found.domains) *result.seconds += domain.seconds;
  result.record = DynamicRecord{std::move(found.domains), std::move(found.overlaps), found.fit_error};
  return result;
}

std::vector<std::string> warnings_of(const Tests& tests, const Stage& stage, const TestResult& test) {
  constexpr double tolerance = 0.03;
  std::vector<std::string> warnings;
  const auto* dynamic = std::get_if<DynamicRecord>(&test.record);
  if (dynamic == nullptr) return warnings;
  for (const auto& [window, mismatch] : dynamic->overlaps) {
    if (mismatch <= tolerance) continue;
    warnings.push_back(fmt::format(
        "{} {}, {}: two time domains differ by {:.1f} % between {:.3g} and {:.3g} s; smaller mass scaling factors "
        "or another ramp may reduce the difference",
        stage.name, name_of(test.id.load), name_of(test.id.boundary), 100.0 * mismatch, window.begin, window.end));
  }
  for (const auto& warning : warnings_on_domains(tests, test.id.boundary, dynamic->domains)) {
    warnings.push_back(
        fmt::format("{} {}, {}: {}", stage.name, name_of(test.id.load), name_of(test.id.boundary), warning));
  }
  return warnings;
}

std::optional<std::string> warning_of_basis(const Tests& tests, const Stage& stage,
                                            const std::vector<TestResult>& of_loads) {
  const auto [tolerance, most_snapshots] = sampling_of(tests);
  double error = 0.0;
  for (const auto& test : of_loads) {
    const auto* record = std::get_if<QuasistaticRecord>(&test.record);
    if (record == nullptr || !record->reduced) return std::nullopt;
    if (static_cast<int>(record->reduced->snapshots.size()) < most_snapshots) return std::nullopt;
    error = std::max(error, test.error_estimate);
  }
  if (error <= tolerance) return std::nullopt;
  return fmt::format(
      "{} {}, {}: the error of the reduced basis is {:.1g} % after {} snapshots, where tests.quasistatic.tolerance "
      "asks "
      "for {:.1g} %; it is part of the printed error; tests.quasistatic.range = \"times\" takes fewer moduli, and "
      "tests.solver = \"stepping\" has no basis",
      stage.name, name_of(of_loads.front().id.boundary), words_of(of_loads.front().id.grid), 100.0 * error,
      most_snapshots, 100.0 * tolerance);
}

}  // namespace breccia
