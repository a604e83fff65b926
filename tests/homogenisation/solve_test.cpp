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

#include "homogenisation/quality.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// Without particles the modulus is that of the matrix at all times.
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
class Recorder : public StudySink {
 public:
  void happened(const StudyEvent& event) override {
    std::visit([this](const auto& one) { note(one); }, event);
  }

  std::vector<std::string> calls;

 private:
  void note(const StageAdopted& event) { calls.push_back("adopted " + event.stage.name); }
  void note(const StagePacked& event) { calls.push_back("packed " + event.stage.name); }
  void note(const TestFinished& event) {
    calls.push_back("tested " + event.stage.name + " " + name_of(event.result.stages.back().tests.back().id.load));
  }
  void note(const AllLoadsFinished& event) { calls.push_back("all of " + event.stage.name); }
  void note(const StageFinished& event) { calls.push_back("finished " + event.stage.name); }
  void note(const StudyFinished& event) { calls.emplace_back(event.result.seconds ? "finished" : "too early"); }
  void note(const DomainFinished& /*event*/) {}
  void note(const FieldsStoredBefore& /*event*/) {}
};

TEST(Solve, PassesItsPartsToASinkAsTheyAreComputed) {
  auto study = test::two_stages();
  study.tests.boundaries = {Boundary::displacement};
  Recorder recorder;
  const auto result = solve(study, {.threads = 1}, recorder);
  EXPECT_THAT(recorder.calls,
              ElementsAre("packed fine", "tested fine shear", "tested fine bulk", "all of fine", "finished fine",
                          "packed coarse", "tested coarse shear", "all of coarse", "finished coarse", "finished"));
  EXPECT_TRUE(result.seconds.has_value());
}

/// A sink that knows the results of stages that were solved before.
class Memory final : public Recorder {
 public:
  explicit Memory(StudyResult before) : before_(std::move(before)) {}

  std::optional<StageResult> known_stage(const Stage& stage) override {
    const auto known = std::ranges::find(before_.stages, stage.name, &StageResult::name);
    return known == before_.stages.end() ? std::nullopt : std::optional(*known);
  }

 private:
  StudyResult before_;
};

TEST(Solve, TakesOverStagesThatASinkKnows) {
  const auto study = test::two_stages();
  const auto solved = solve(study);
  auto first_alone = solved;
  first_alone.stages.pop_back();
  Memory memory(first_alone);
  const auto result = solve(study, {}, memory);
  EXPECT_THAT(memory.calls, ElementsAre("adopted fine", "packed coarse", "tested coarse shear", "all of coarse",
                                        "tested coarse shear", "all of coarse", "finished coarse", "finished"));
  ASSERT_THAT(result.stages, SizeIs(2));
  for (std::size_t stage = 0; stage < 2; ++stage) {
    ASSERT_EQ(result.stages[stage].tests.size(), solved.stages[stage].tests.size());
    EXPECT_EQ(result.stages[stage].tests.back().modulus, solved.stages[stage].tests.back().modulus);
    EXPECT_EQ(result.stages[stage].accuracy.summary, solved.stages[stage].accuracy.summary);
    EXPECT_EQ(result.stages[stage].accuracy.summary,
              summary_of(quality_of(study, study.stages[stage], solved.stages[stage])));
  }
}

/// A sink that stores the fields of tests.
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
  const auto result = solve(study, {}, store);
  EXPECT_THAT(store.stored, ElementsAre(TestId{.grid = TestGrid(12)}));
  EXPECT_THAT(times_of(result.stages.front().tests.front().fields), IsEmpty());
}

/// A sink that keeps the names of the calculations that report progress, each once.
class Follower final : public StudySink {
 public:
  void progress(const Progress& now) override {
    if (std::ranges::find(begun, now.what) == begun.end()) begun.push_back(now.what);
  }
  void happened(const StudyEvent& event) override {
    const auto* domain = std::get_if<DomainFinished>(&event);
    if (domain != nullptr && std::ranges::find(domains, domain->test) == domains.end()) domains.push_back(domain->test);
  }

  std::vector<std::string> begun;
  std::vector<TestId> domains;
};

TEST(Solve, TellsWhichTestItIsAt) {
  auto study = test::two_stages();
  study.stages = {{.name = "plain", .matrix = test::binder, .side = 6e-3, .cells = 6, .coarser_cells = {4}}};
  study.tests.boundaries = {Boundary::displacement};
  study.tests.methods = {Method::quasistatic, Method::dynamic};
  Follower follower;
  static_cast<void>(solve(study, {.threads = 1}, follower));
  const auto test_on = [](Method method, int cells) {
    return TestId{Load::shear, Boundary::displacement, method, TestGrid(cells)};
  };
  const auto name_on = [&](Method method, int cells) { return "plain " + calculation_of(test_on(method, cells)); };
  EXPECT_THAT(follower.begun, ElementsAre(name_on(Method::quasistatic, 4), name_on(Method::dynamic, 4),
                                          name_on(Method::quasistatic, 6), name_on(Method::dynamic, 6)));
  EXPECT_THAT(follower.domains, ElementsAre(test_on(Method::dynamic, 4), test_on(Method::dynamic, 6)));
}

TEST(Solve, RefusesAStudyThatIsNotSound) {
  auto study = test::two_stages();
  study.stages[0].matrix = EarlierStage{"none"};
  EXPECT_THROW(static_cast<void>(solve(study)), InputError);
}

/// A sink that ends a solution at its first event.
class Stopper final : public StudySink {
 public:
  void happened(const StudyEvent& /*event*/) override { throw Interrupted("enough"); }
};

TEST(Solve, AnExceptionOfASinkEndsIt) {
  Stopper stopper;
  EXPECT_THROW(static_cast<void>(solve(test::two_stages(), {}, stopper)), Interrupted);
}

}  // namespace
}  // namespace breccia
