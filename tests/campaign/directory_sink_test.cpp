// Tests of the content of a directory of results after each step of a solution.

#include "campaign/directory_sink.hpp"

#include <algorithm>
#include <filesystem>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "campaign/deck_study.hpp"
#include "campaign/sweep.hpp"
#include "one_vector_response.hpp"
#include "results/history_file.hpp"
#include "results/response_file.hpp"
#include "results/study_record.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const TestId in_shear{Load::shear, Boundary::displacement, Method::quasistatic, TestGrid(12)};

/// The stage "fine" with one test of the reduced solver.
StudyResult solved() {
  auto result = test::tested_result();
  auto& stage = result.stages.front();
  stage.cells = 12;
  stage.microstructure.box = Microstructure<2>{6e-3, Walls::hard, {{{1e-3, 1e-3}, 2e-3}}};
  QuasistaticRecord record;
  record.reduced = test::one_vector_response(Load::shear, Boundary::displacement, {3.0, 2.0, 0.0},
                                             {{{{.bulk = 1e9, .shear = 1e6}}, 0.0}});
  stage.tests.front().record = std::move(record);
  return result;
}

/// Two tasks with the same stage.
Sweep two_tasks() {
  Sweep sweep;
  for (int task = 0; task < 2; ++task) sweep.tasks.emplace_back().study = test::study_of_deck("two scales");
  return sweep;
}

/// A run in a directory that has begun.
struct BegunRun : ResultTransaction {
  BegunRun(const Study& study, const fs::path& directory) : ResultTransaction(study, directory, {}) { begin_run(); }
};

class DirectorySinkTest : public testing::Test {
 protected:
  [[nodiscard]] const Stage& fine() const { return study.stages.front(); }
  [[nodiscard]] DirectorySink sink_of(const BegunRun& begun) { return {begun, observer, shared}; }
  [[nodiscard]] static std::vector<std::string> files(const fs::path& results) {
    std::vector<std::string> names;
    if (!fs::exists(results)) return names;
    for (const auto& entry : fs::directory_iterator(results)) {
      if (entry.is_regular_file()) names.push_back(entry.path().filename().string());
    }
    return names;
  }
  /// Passes the events of a whole stage to a sink.
  void finish_stage(DirectorySink& sink) const {
    const auto result = solved();
    static_cast<void>(sink.known_stage(fine()));
    static_cast<void>(sink.packing_checkpoint(fine()));
    sink.happened(StagePacked{fine(), result});
    sink.happened(TestFinished{fine(), result});
    sink.happened(AllLoadsFinished{fine(), result});
    sink.happened(StageFinished{fine(), result});
  }

  const Study study = test::study_of_deck("two scales");
  RunObserver observer;
  SharedStages shared{two_tasks()};
  test::TemporaryDirectory directory;
  const fs::path place = directory.path() / "results", other = directory.path() / "other";
  const BegunRun run{study, place};
};

TEST_F(DirectorySinkTest, WritesEachPartAsItIsFound) {
  auto sink = sink_of(run);
  const auto result = solved();
  EXPECT_FALSE(sink.known_stage(fine()));
  EXPECT_NE(sink.packing_checkpoint(fine()), nullptr);
  EXPECT_TRUE(fs::is_directory(place / "fine"));
  EXPECT_FALSE(read_study_record(place).has_tests);
  EXPECT_THAT(read_study_record(place).stages_packed, IsEmpty());

  auto packed = result;
  packed.stages.front().tests.clear();
  sink.happened(StagePacked{fine(), packed});
  EXPECT_THAT(files(place), ElementsAre("study.json"));
  EXPECT_THAT(files(place / "fine"),
              UnorderedElementsAre("labels.npy", "labels.vti", "microstructure.csv", "microstructure.svg"));
  EXPECT_FALSE(read_study_record(place).has_tests);

  sink.happened(TestFinished{fine(), result});
  EXPECT_THAT(files(place), UnorderedElementsAre("study.json", "curves.csv", "prony.csv", "quality.csv"));
  EXPECT_TRUE(read_study_record(place).has_tests);

  sink.happened(AllLoadsFinished{fine(), result});
  EXPECT_EQ(read_responses(place / "fine" / "response.h5").entries.size(), 1U);

  sink.happened(StageFinished{fine(), result});
  EXPECT_THAT(files(place),
              UnorderedElementsAre("study.json", "curves.csv", "prony.csv", "quality.csv", "report.html"));
  EXPECT_FALSE(read_study_record(place).is_complete);

  write_text(place / "fine" / "packing.checkpoint.h5", "");
  auto complete = result;
  complete.seconds = 2.5;
  sink.happened(StudyFinished{complete});
  EXPECT_TRUE(read_study_record(place).is_complete_run_of(study));
  EXPECT_THAT(files(place / "fine"), UnorderedElementsAre("labels.npy", "labels.vti", "microstructure.csv",
                                                          "microstructure.svg", "modulus.svg", "response.h5"));
}

TEST_F(DirectorySinkTest, WritesTheHistoryOfEachTimeDomain) {
  auto sink = sink_of(run);
  fs::create_directory(place / "fine");
  TimeDomain domain;
  domain.history = {{0.0, 1.0}, {1.0, 0.5}};
  sink.happened(DomainFinished{fine(), {Load::bulk, Boundary::displacement, Method::dynamic, TestGrid(12)}, 2, domain});
  const auto history = read_history(place / "fine" / "bulk-displacement-dynamic-12-2.h5");
  EXPECT_THAT(history.values, ElementsAre(1.0, 0.5));
  EXPECT_EQ(history.deck_hash, study.provenance.hash);
}

TEST_F(DirectorySinkTest, NamesCheckpointsByTheTestsThatGoOnFromThem) {
  const auto name_of_checkpoint = [&](const TestId& test) {
    auto sink = sink_of(run);
    fs::create_directories(place / "fine");
    sink.test_checkpoint(fine(), test)->save([](StateWriter& state) { state.write("/number", 1.0); });
    const auto names = files(place / "fine");
    fs::remove_all(place / "fine");
    return names.size() == 1 ? names.front() : "";
  };
  EXPECT_EQ(name_of_checkpoint(in_shear), "displacement-quasistatic-12.checkpoint.h5") << "one for all loads";
  EXPECT_EQ(name_of_checkpoint({Load::bulk, Boundary::traction, Method::dynamic, TestGrid(24)}),
            "bulk-traction-dynamic-24.checkpoint.h5");
}

TEST_F(DirectorySinkTest, TakesAStageOverFromAnotherTask) {
  {
    auto sink = sink_of(run);
    finish_stage(sink);
    EXPECT_TRUE(sink.store_fields(fine(), in_shear, GridFields<2>{{{12, 12}, 0.5e-3}, {}}));
  }
  fs::path told;
  observer.event = [&](const RunEvent& event) {
    const auto* taken_over = std::get_if<StageTakenOver>(&event);
    if (taken_over == nullptr) return;
    EXPECT_EQ(taken_over->stage.name, "fine");
    told = taken_over->directory;
  };
  const BegunRun another(study, other);
  auto sink = sink_of(another);
  const auto known = sink.known_stage(fine());
  ASSERT_TRUE(known);
  EXPECT_EQ(known->tests.front().modulus, solved().stages.front().tests.front().modulus);
  const StudyResult adopted{{*known}, {}};
  sink.happened(StageAdopted{fine(), adopted});
  EXPECT_EQ(told, place / "fine");
  EXPECT_THAT(files(other),
              UnorderedElementsAre("study.json", "curves.csv", "prony.csv", "quality.csv", "report.html"));
  EXPECT_THAT(files(other / "fine"), UnorderedElementsAre("labels.npy", "labels.vti", "microstructure.csv",
                                                          "microstructure.svg", "modulus.svg", "response.h5"));
  EXPECT_EQ(read_text(other / "curves.csv"), read_text(place / "curves.csv"));
}

TEST_F(DirectorySinkTest, FailsAtOnceWhereAnotherTaskHasFailed) {
  {
    auto sink = sink_of(run);
    static_cast<void>(sink.known_stage(fine()));
    sink.keep_failure(std::make_exception_ptr(NumericalError("jammed")));
  }
  const BegunRun another(study, other);
  auto sink = sink_of(another);
  EXPECT_THROW(static_cast<void>(sink.known_stage(fine())), NumericalError);
}

}  // namespace
}  // namespace breccia
