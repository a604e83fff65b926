#include "stage_tests.hpp"

#include <memory>
#include <utility>
#include <variant>

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
  return TestGrid(cells_along(grid.discretisation));
}

/// Gives the fields of a test, which are large, to the sink, and leaves the state of the finished test. The sink of an
/// earlier run that had finished the test has taken its fields already.
/// `fields` are those of the result, `take` gives them to the sink.
template <class Found, class Fields, class Take>
void hand_over(const Stage& stage, Found& found, Fields& fields, const Take& take, Checkpoint* checkpoint,
               StudySink& sink, const TestId& test) {
  if (checkpoint != nullptr && checkpoint->is_finished()) {
    sink.fields_taken_before(stage, test, read_field_times(*checkpoint->earlier()));
    return;
  }
  std::vector<double> times_taken;
  if (take(fields)) {
    for (const auto& timed : fields) times_taken.push_back(timed.time);
    fields.clear();
  }
  if (checkpoint == nullptr) return;
  checkpoint->finish([&](StateWriter& state) {
    save_result(state, found);
    save_field_times(state, times_taken);
  });
}

/// The same for the fields of the points of a square.
template <class Found>
void hand_over_fields(const StageGrid& grid, const Discretisation<2>& square, Found& found, Checkpoint* checkpoint,
                      StudySink& sink, TestResult& result) {
  result.fields = std::exchange(found.fields, {});
  hand_over(
      *grid.stage, found, result.fields,
      [&](const auto& fields) { return sink.take_fields(*grid.stage, result.id, square, fields); }, checkpoint, sink,
      result.id);
}

/// The same for the fields of the cells of a cube.
template <class Found>
void hand_over_fields(const StageGrid& grid, const Discretisation<3>& cube, Found& found, Checkpoint* checkpoint,
                      StudySink& sink, TestResult& result) {
  result.volume_fields = std::exchange(found.volume_fields, {});
  hand_over(
      *grid.stage, found, result.volume_fields,
      [&](const auto& fields) { return sink.take_volume_fields(*grid.stage, result.id, cube, fields); }, checkpoint,
      sink, result.id);
}

/// Runs a quasi-static test of all loads, with its checkpoint, and makes results of it.
class QuasistaticRun {
 public:
  QuasistaticRun(const Stage& stage, const QuasistaticTest& test, TestGrid grid, const StudyObserver& observer,
                 StudySink& sink) {
    const TestId first{test.loads.front(), test.boundary, Method::quasistatic, grid};
    checkpoint_ = sink.test_checkpoint(stage, first);
    found_ = name_errors(fmt::format("{} {}", stage.name, calculation_of(first)), [&] {
      // The first elastic solution may take long.
      if (observer.progress) observer.progress(stage, first, 0.0, "begun");
      return run_quasistatic_test(
          test,
          [&](const std::string& details, double share) {
            if (observer.progress) observer.progress(stage, first, share, details);
          },
          checkpoint_.get());
    });
    for (const auto& response : found_.responses) {
      results_.push_back({.id = {response.load, test.boundary, Method::quasistatic, grid}});
    }
  }

  [[nodiscard]] QuasistaticTestResult& found() noexcept { return found_; }
  [[nodiscard]] Checkpoint* checkpoint() const noexcept { return checkpoint_.get(); }
  [[nodiscard]] TestResult& first_result() noexcept { return results_.front(); }

  /// The results by load. Call it once.
  [[nodiscard]] std::vector<TestResult> take_results() {
    for (std::size_t i = 0; i < results_.size(); ++i) {
      auto& response = found_.responses[i];
      results_[i].modulus = std::exchange(response.modulus, {});
      results_[i].compliance = std::exchange(response.compliance, {});
      results_[i].series = response.series;
      results_[i].record = QuasistaticRecord{std::move(response), found_.effort, found_.seconds};
    }
    return std::move(results_);
  }

 private:
  std::unique_ptr<Checkpoint> checkpoint_;
  QuasistaticTestResult found_;
  std::vector<TestResult> results_;
};

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
  auto test = make_quasistatic_test(*grid.study, *grid.stage, matrix, grid.discretisation, boundary, grid.threads);
  test.relaxation = std::move(relaxation);
  QuasistaticRun run(*grid.stage, test, grid_of(grid), observer, sink);
  std::visit(
      [&](const auto& composite) {
        hand_over_fields(grid, composite, run.found(), run.checkpoint(), sink, run.first_result());
      },
      grid.discretisation);
  return run.take_results();
}

std::vector<TestResult> run_films(const StageFilms& films, const Material& matrix,
                                  std::vector<std::vector<Moduli>> relaxation, Boundary boundary,
                                  const StudyObserver& observer, StudySink& sink) {
  auto test = make_film_test(*films.study, *films.stage, matrix, *films.grains, boundary, films.threads);
  test.relaxation = std::move(relaxation);
  QuasistaticRun run(*films.stage, test, TestGrid::films(), observer, sink);
  auto& result = run.first_result();
  result.film_fields = std::exchange(run.found().film_fields, {});
  hand_over(
      *films.stage, run.found(), result.film_fields,
      [&](const auto& fields) { return sink.take_film_fields(*films.stage, result.id, fields); }, run.checkpoint(),
      sink, result.id);
  return run.take_results();
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
  const auto checkpoint = sink.test_checkpoint(stage, result.id);
  const auto run = [&](const auto& discretisation) {
    const auto test = make_dynamic_test(*grid.study, stage, matrix, discretisation, boundary, load, grid.threads);
    auto found = name_errors(fmt::format("{} {}", stage.name, calculation_of(result.id)),
                             [&] { return run_dynamic_test(test, follow, checkpoint.get()); });
    hand_over_fields(grid, discretisation, found, checkpoint.get(), sink, result);
    return found;
  };
  auto found = std::visit(run, grid.discretisation);
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
