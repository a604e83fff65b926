#include "stage_tests.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/parallel/session.hpp"
#include "breccia/virtual_test/dynamic_test_state.hpp"
#include "breccia/virtual_test/quasistatic_test_state.hpp"
#include "breccia/viscoelasticity/fit.hpp"

#include "field_files.hpp"
#include "history_file.hpp"
#include "named_errors.hpp"
#include "results.hpp"

namespace breccia {
namespace {

std::vector<Material> materials_of(const Stage& stage, const Material& matrix) {
  std::vector<Material> materials = {matrix};
  if (stage.filler) materials.push_back(stage.filler->material);
  return materials;
}

/// Writes the fields of a test, by the first of several processes, and then leaves the result as finished; of one that
/// had been finished before, tells what was written then. Fields are large: they are not kept.
template <class Result>
std::vector<FieldRecord> fields_of(const StageGrid& grid, Boundary boundary, Method method, Checkpoint& checkpoint,
                                   Result& result) {
  if (checkpoint.is_finished()) return read_field_records(*checkpoint.earlier());
  const auto fields = std::exchange(result.fields, {});
  std::vector<FieldRecord> records;
  if (parallel::rank() == 0) records = write_fields(grid, boundary, method, fields);
  checkpoint.finish([&](StateWriter& state) {
    save_result(state, result);
    save(state, records);
  });
  return records;
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

DynamicTest make_dynamic_test(const Study& study, const Stage& stage, const Material& matrix,
                              const Discretisation<2>& discretisation, Boundary boundary, Load load, int threads) {
  return {.discretisation = discretisation,
          .materials = materials_of(stage, matrix),
          .boundary = boundary,
          .load = load,
          .times = {study.tests.first_time, study.tests.last_time},
          .points_per_decade = study.tests.points_per_decade,
          .field_times = field_times_of(study, stage, discretisation, load),
          .options = study.tests.dynamic,
          .threads = threads};
}

QuasistaticTest make_quasistatic_test(const Study& study, const Stage& stage, const Material& matrix,
                                      const Discretisation<2>& discretisation, Boundary boundary, int threads) {
  auto options = study.tests.quasistatic;
  options.linear.threads = threads;
  return {.discretisation = discretisation,
          .materials = materials_of(stage, matrix),
          .boundary = boundary,
          .loads = loads_of(study, stage),
          .times = {study.tests.first_time, study.tests.last_time},
          .points_per_decade = study.tests.points_per_decade,
          .field_times = field_times_of(study, stage, discretisation, study.tests.loads.front()),
          .options = options};
}

std::vector<TestResult> run_quasistatic(const StageGrid& grid, const Material& matrix,
                                        std::vector<Moduli> matrix_moduli, Boundary boundary,
                                        const StudyObserver& observer) {
  const auto& stage = *grid.stage;
  const int cells = grid.discretisation.grid().columns();
  const auto name = fmt::format("{}, {} cells, quasi-static", bound_of(boundary), cells);
  auto checkpoint = grid.checkpoints->of_quasistatic(stage, boundary, cells);
  auto test = make_quasistatic_test(*grid.study, stage, matrix, grid.discretisation, boundary, grid.threads);
  test.matrix_moduli = std::move(matrix_moduli);
  auto done = name_errors(fmt::format("{} {}", stage.name, name), [&] {
    // The first elastic solution may take long.
    if (observer.progress) observer.progress(stage, name, 0.0, "begun");
    return run_quasistatic_test(
        test,
        [&](const std::string& details, double share) {
          if (observer.progress) observer.progress(stage, name, share, details);
        },
        &checkpoint);
  });
  auto fields = fields_of(grid, boundary, Method::quasistatic, checkpoint, done);
  std::vector<TestResult> results;
  for (auto& response : done.responses) {
    TestResult result{.load = response.load, .boundary = boundary, .method = Method::quasistatic, .cells = cells};
    result.modulus = std::exchange(response.modulus, {});
    result.compliance = std::exchange(response.compliance, {});
    result.series = response.series;
    result.record = QuasistaticRecord{std::move(response), done.effort, done.seconds};
    results.push_back(std::move(result));
  }
  results.front().fields = std::move(fields);
  return results;
}

TestResult run_dynamic(const StageGrid& grid, const Material& matrix, Boundary boundary, Load load,
                       const StudyObserver& observer) {
  const auto& stage = *grid.stage;
  const int cells = grid.discretisation.grid().columns();
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
  const auto test = make_dynamic_test(*grid.study, stage, matrix, grid.discretisation, boundary, load, grid.threads);
  auto checkpoint = grid.checkpoints->of_dynamic(stage, load, boundary, cells);
  auto done =
      name_errors(fmt::format("{} {}", stage.name, name), [&] { return run_dynamic_test(test, follow, &checkpoint); });
  TestResult result{.load = load, .boundary = boundary, .method = Method::dynamic, .cells = cells};
  result.fields = fields_of(grid, boundary, Method::dynamic, checkpoint, done);
  result.modulus = std::exchange(done.curve, {});
  result.compliance = std::exchange(done.compliance, {});
  result.series = fitted(result.modulus);
  result.record = std::move(done);
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
        "or another ramp bring them together",
        stage.name, name_of(test.load), bound_of(test.boundary), 100.0 * mismatch, window.begin, window.end));
  }
  return warnings;
}

}  // namespace breccia
