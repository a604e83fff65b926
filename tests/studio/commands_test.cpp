#include <chrono>
#include <filesystem>
#include <future>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "io/text_file.hpp"
#include "studio/command_runner.hpp"
#include "studio/running_study.hpp"
#include "temporary_directory.hpp"

namespace breccia::studio {
namespace {

using std::chrono::milliseconds;

/// A shell in the place of the program: the arguments of a command are its own.
Program shell(const std::filesystem::path& folder) {
  return {"/bin/sh", folder};
}

Command script(const std::string& text) {
  return {.arguments = {"-c", text}};
}

RunStatus ended(const RunningStudy& run) {
  while (run.status()->state == RunState::running) std::this_thread::sleep_for(milliseconds(10));
  return *run.status();
}

TEST(LatestCommands, ReturnsWhatACommandPrints) {
  const test::TemporaryDirectory directory;
  LatestCommands commands(shell(directory.path()));
  const auto finished = commands.run("a", script("echo one; echo two >&2; exit 3"));
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->output, "one\ntwo\n");
  EXPECT_EQ(finished->exit_code, 3);
}

TEST(LatestCommands, EndsAnEarlierOne) {
  const test::TemporaryDirectory directory;
  LatestCommands commands(shell(directory.path()));
  auto first = std::async(std::launch::async, [&] { return commands.run("a", script("touch begun; sleep 100")); });
  while (!std::filesystem::exists(directory.path() / "begun")) std::this_thread::sleep_for(milliseconds(5));
  const auto second = commands.run("a", script("echo second"));
  ASSERT_TRUE(second);
  EXPECT_EQ(second->output, "second\n");
  EXPECT_FALSE(first.get());
}

TEST(LatestCommands, LetsThoseAboutOthersGoOn) {
  const test::TemporaryDirectory directory;
  LatestCommands commands(shell(directory.path()));
  auto first = std::async(std::launch::async, [&] {
    return commands.run("a", script("touch begun; until test -e go; do sleep 0.01; done; echo first"));
  });
  while (!std::filesystem::exists(directory.path() / "begun")) std::this_thread::sleep_for(milliseconds(5));
  EXPECT_TRUE(commands.run("b", script("touch go")));
  const auto finished = first.get();
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->output, "first\n");
}

TEST(LatestCommands, RunsNoneAfterItsEnd) {
  const test::TemporaryDirectory directory;
  LatestCommands commands(shell(directory.path()));
  auto first = std::async(std::launch::async, [&] { return commands.run("a", script("touch begun; sleep 100")); });
  while (!std::filesystem::exists(directory.path() / "begun")) std::this_thread::sleep_for(milliseconds(5));
  commands.end();
  EXPECT_FALSE(first.get());
  EXPECT_FALSE(commands.run("a", script("echo second")));
}

TEST(RunningStudy, ShowsProgressAndTheEnd) {
  const test::TemporaryDirectory directory;
  RunningStudy run(shell(directory.path()));
  EXPECT_FALSE(run.status());
  ASSERT_TRUE(
      run.start(script("echo begun; printf 'a: 45 %%, so far'; until test -e go; do sleep 0.01; done; echo; exit 0"),
                "a.toml", "results/a"));
  EXPECT_FALSE(run.start(script("true"), "b.toml", "results/b"));
  while (run.status()->live_line != "a: 45 %, so far") std::this_thread::sleep_for(milliseconds(10));
  EXPECT_EQ(run.status()->output, "begun\n");
  EXPECT_EQ(run.status()->state, RunState::running);
  EXPECT_GT(run.status()->seconds, 0.0);
  write_text(directory.path() / "go", "");
  const auto done = ended(run);
  EXPECT_EQ(done.state, RunState::done);
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_EQ(done.live_line, "");
  EXPECT_EQ(done.deck, "a.toml");
  ASSERT_TRUE(run.start(script("echo no; exit 3"), "b.toml", "results/b"));
  const auto failed = ended(run);
  EXPECT_EQ(failed.state, RunState::failed);
  EXPECT_EQ(failed.id, done.id + 1);
  EXPECT_EQ(failed.output, "no\n");
}

TEST(RunningStudy, StopsAsACommandDoesByControlC) {
  const test::TemporaryDirectory directory;
  const auto waits = script("trap 'echo saved; exit 130' INT; touch begun; while :; do sleep 0.02; done");
  const auto wait_for_begin = [&] {
    while (!std::filesystem::exists(directory.path() / "begun")) std::this_thread::sleep_for(milliseconds(5));
  };
  RunningStudy run(shell(directory.path()));
  run.stop();
  ASSERT_TRUE(run.start(waits, "a.toml", "results/a"));
  wait_for_begin();
  run.stop();
  EXPECT_EQ(ended(run).state, RunState::stopped);
  EXPECT_NE(run.status()->output.find("saved"), std::string::npos);
}

TEST(RunningStudy, AtItsEndIsAskedToStopAndWaitedFor) {
  const test::TemporaryDirectory directory;
  {
    RunningStudy run(shell(directory.path()));
    ASSERT_TRUE(run.start(script("trap 'touch saved; exit 130' INT; touch begun; while :; do sleep 0.02; done"),
                          "a.toml", "results/a"));
    while (!std::filesystem::exists(directory.path() / "begun")) std::this_thread::sleep_for(milliseconds(5));
  }
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "saved"));
}

}  // namespace
}  // namespace breccia::studio
