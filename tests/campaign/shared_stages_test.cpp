#include "campaign/shared_stages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "campaign/sweep.hpp"
#include "results/hand_made_results.hpp"

namespace breccia {
namespace {

/// A sweep of tasks whose stages have these hashes.
Sweep sweep_of(const std::vector<std::vector<std::string>>& hashes) {
  Sweep sweep;
  for (const auto& of_task : hashes) sweep.tasks.emplace_back().study.provenance.stage_hashes = of_task;
  return sweep;
}

SharedStages::Entry entry_in(const std::filesystem::path& directory) {
  SharedStages::Entry entry;
  entry.result = test::stage_with("fine", {});
  entry.directory = directory;
  return entry;
}

TEST(SharedStages, AreThoseOfSeveralTasks) {
  SharedStages shared(sweep_of({{"fine", "coarse 1"}, {"fine", "coarse 2"}}));
  EXPECT_EQ(shared.find("fine"), nullptr) << "no task has come to it";
  shared.keep("fine", entry_in("results/1/fine"));
  shared.keep("coarse 1", entry_in("results/1/coarse"));
  shared.keep("elsewhere", entry_in("results/1/elsewhere"));
  ASSERT_NE(shared.find("fine"), nullptr);
  EXPECT_EQ(shared.find("fine")->result.name, "fine");
  EXPECT_EQ(shared.find("fine")->directory, "results/1/fine");
  EXPECT_EQ(shared.find("coarse 1"), nullptr) << "no other task has it";
  EXPECT_EQ(shared.find("elsewhere"), nullptr);
}

TEST(SharedStages, AreNoneOfASingleStudy) {
  SharedStages shared;
  shared.keep("fine", entry_in("results/fine"));
  EXPECT_EQ(shared.find("fine"), nullptr);
  shared.keep("", entry_in("results/fine"));
  EXPECT_EQ(shared.find(""), nullptr);
}

TEST(SharedStages, FollowTheirFiles) {
  SharedStages shared(sweep_of({{"a", "b"}, {"a", "b"}}));
  shared.keep("a", entry_in("results/1/unfinished/fine"));
  shared.keep("b", entry_in("results/2/fine"));
  shared.move_files("results/1/unfinished", "results/1");
  EXPECT_EQ(shared.find("a")->directory, "results/1/fine");
  EXPECT_EQ(shared.find("b")->directory, "results/2/fine");
}

// The second task fails for the same reason at once.
TEST(SharedStages, KeepTheReasonWhyThereIsNoResult) {
  SharedStages shared(sweep_of({{"a"}, {"a"}}));
  SharedStages::Entry entry;
  entry.failure = std::make_exception_ptr(NumericalError("jammed"));
  shared.keep("a", entry);
  ASSERT_NE(shared.find("a"), nullptr);
  EXPECT_THROW(std::rethrow_exception(shared.find("a")->failure), NumericalError);
}

}  // namespace
}  // namespace breccia
