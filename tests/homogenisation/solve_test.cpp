#include "breccia/homogenisation/solve.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/campaign/run.hpp"
#include "breccia/error.hpp"

#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// Without particles the box is its matrix: the modulus is that of the material at all times.
TEST(Solve, ABoxWithoutParticlesHasTheModulusOfItsMatrix) {
  Study study;
  study.stages = {{.name = "plain", .matrix = test::binder, .side = 1e-3, .cells = 4}};
  study.tests.first_time = 1e-4;
  study.tests.last_time = 0.1;
  study.tests.boundaries = {Boundary::displacement, Boundary::traction, Boundary::periodic};
  const auto result = solve(study);
  ASSERT_THAT(result.stages, SizeIs(1));
  ASSERT_THAT(result.stages.front().tests, SizeIs(3));
  for (const auto& test : result.stages.front().tests) {
    for (const auto& [time, modulus] : test.modulus) {
      EXPECT_NEAR(modulus / test::binder.shear.at(time), 1.0, 1e-8) << name_of(test.id.boundary) << ", " << time;
    }
  }
}

TEST(Solve, GivesTheBitsOfARunInADirectory) {
  auto study = test::two_stages();
  study.tests.methods = {Method::quasistatic, Method::dynamic};
  const auto solved = solve(study);
  const test::TemporaryDirectory directory;
  const auto run = run_study(study, directory.path() / "results");
  ASSERT_EQ(solved.stages.size(), run.stages.size());
  for (std::size_t i = 0; i < run.stages.size(); ++i) {
    const auto &one = solved.stages[i].tests, &other = run.stages[i].tests;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t test = 0; test < one.size(); ++test) {
      EXPECT_EQ(one[test].id, other[test].id);
      EXPECT_EQ(one[test].modulus, other[test].modulus);
      EXPECT_EQ(one[test].compliance, other[test].compliance);
    }
  }
}

TEST(Solve, KeepsFieldsInTheMemoryAndWritesNoFile) {
  auto study = test::two_stages();
  study.tests.field_times = {study.tests.last_time};
  const auto entries = [] {
    const std::filesystem::directory_iterator all(std::filesystem::current_path());
    return std::distance(begin(all), end(all));
  };
  const auto before = entries();
  const auto result = solve(study);
  EXPECT_EQ(entries(), before);
  const auto& in_shear = result.stages.back().tests.front();
  EXPECT_THAT(times_of(in_shear.fields), ElementsAre(study.tests.last_time));
  const auto& fields = std::get<GridFields<2>>(in_shear.fields);
  EXPECT_THAT(fields.at_times.front().fields.stress, SizeIs(result.stages.back().points));
}

/// A sink that records its calls.
class Recorder final : public StudySink {
 public:
  void packed(const Stage& stage, const StudyResult&) override { calls.push_back("packed " + stage.name); }
  void tested(const Stage& stage, const StudyResult& result) override {
    calls.push_back("tested " + stage.name + " " + name_of(result.stages.back().tests.back().id.load));
  }
  void all_loads_tested(const Stage& stage, const StudyResult&) override { calls.push_back("all of " + stage.name); }
  void stage_finished(const Stage& stage, const StudyResult&) override { calls.push_back("finished " + stage.name); }

  std::vector<std::string> calls;
};

TEST(Solve, PassesItsPartsToASinkAsTheyAreComputed) {
  auto study = test::two_stages();
  study.tests.boundaries = {Boundary::displacement};
  Recorder recorder;
  const auto result = solve(study, {.threads = 1}, {}, recorder);
  EXPECT_THAT(recorder.calls,
              ElementsAre("packed fine", "tested fine shear", "tested fine bulk", "all of fine", "finished fine",
                          "packed coarse", "tested coarse shear", "all of coarse", "finished coarse"));
  EXPECT_TRUE(result.seconds.has_value());
}

/// Knows the results of stages that were solved before.
class Memory final : public StudySink {
 public:
  explicit Memory(StudyResult before) : before_(std::move(before)) {}

  std::optional<StageResult> known_stage(const Stage& stage) override {
    const auto known = std::ranges::find(before_.stages, stage.name, &StageResult::name);
    return known == before_.stages.end() ? std::nullopt : std::optional(*known);
  }
  void stage_adopted(const Stage& stage, const StudyResult&) override { calls.push_back("adopted " + stage.name); }
  void packed(const Stage& stage, const StudyResult&) override { calls.push_back("packed " + stage.name); }
  void finished(const StudyResult& result) override { calls.emplace_back(result.seconds ? "finished" : "too early"); }

  std::vector<std::string> calls;

 private:
  StudyResult before_;
};

TEST(Solve, TakesOverStagesThatASinkKnows) {
  const auto study = test::two_stages();
  const auto solved = solve(study);
  auto first_alone = solved;
  first_alone.stages.pop_back();
  Memory memory(first_alone);
  const auto result = solve(study, {}, {}, memory);
  EXPECT_THAT(memory.calls, ElementsAre("adopted fine", "packed coarse", "finished"));
  ASSERT_THAT(result.stages, SizeIs(2));
  for (std::size_t stage = 0; stage < 2; ++stage) {
    ASSERT_EQ(result.stages[stage].tests.size(), solved.stages[stage].tests.size());
    EXPECT_EQ(result.stages[stage].tests.back().modulus, solved.stages[stage].tests.back().modulus);
  }
}

/// Stores the fields of tests.
class FieldStore final : public StudySink {
 public:
  bool store_fields(const Stage&, const TestId& test, const TestFields& fields) override {
    if (!times_of(fields).empty()) stored.push_back(test);
    return true;
  }

  std::vector<TestId> stored;
};

TEST(Solve, FieldsThatASinkStoresDoNotStayInTheMemory) {
  auto study = test::two_stages();
  study.stages.pop_back();
  study.tests.boundaries = {Boundary::displacement};
  study.tests.field_times = {study.tests.last_time};
  FieldStore store;
  const auto result = solve(study, {}, {}, store);
  EXPECT_THAT(store.stored, ElementsAre(TestId{.grid = TestGrid(12)}));
  EXPECT_THAT(times_of(result.stages.front().tests.front().fields), IsEmpty());
}

TEST(Solve, TellsWhichTestItIsAt) {
  auto study = test::two_stages();
  study.stages = {{.name = "plain", .matrix = test::binder, .side = 6e-3, .cells = 6, .coarser_cells = {4}}};
  study.tests.boundaries = {Boundary::displacement};
  study.tests.methods = {Method::quasistatic, Method::dynamic};
  std::vector<TestId> begun, domains;
  StudyObserver observer;
  observer.progress = [&](const Stage&, const TestId& test, double, const std::string&) {
    if (std::ranges::find(begun, test) == begun.end()) begun.push_back(test);
  };
  observer.domain_finished = [&](const Stage&, const TestId& test, const TimeDomain&) {
    if (std::ranges::find(domains, test) == domains.end()) domains.push_back(test);
  };
  static_cast<void>(solve(study, {.threads = 1}, observer));
  const auto test_on = [](Method method, int cells) {
    return TestId{Load::shear, Boundary::displacement, method, TestGrid(cells)};
  };
  EXPECT_THAT(begun, ElementsAre(test_on(Method::quasistatic, 4), test_on(Method::dynamic, 4),
                                 test_on(Method::quasistatic, 6), test_on(Method::dynamic, 6)));
  EXPECT_THAT(domains, ElementsAre(test_on(Method::dynamic, 4), test_on(Method::dynamic, 6)));
}

TEST(Solve, RefusesAStudyThatIsNotSound) {
  auto study = test::two_stages();
  study.stages[0].matrix = EarlierStage{"none"};
  EXPECT_THROW(static_cast<void>(solve(study)), InputError);
}

TEST(Solve, AnExceptionOfAnObserverEndsIt) {
  StudyObserver observer;
  observer.packed = [](const Stage&, const StageResult&) { throw Interrupted("enough"); };
  EXPECT_THROW(static_cast<void>(solve(test::two_stages(), {}, observer)), Interrupted);
}

}  // namespace
}  // namespace breccia
