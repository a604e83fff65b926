#include "studio/child_process.hpp"

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "temporary_directory.hpp"

namespace breccia::studio {
namespace {

using std::chrono::milliseconds;

std::string all_of(ChildProcess& process) {
  std::string text;
  while (const auto bytes = process.read(milliseconds(100))) text += *bytes;
  return text;
}

TEST(ChildProcess, HasATerminalAndADirectory) {
  const test::TemporaryDirectory directory;
  ChildProcess process({"/bin/sh", "-c", "test -t 1 && test -t 2 && pwd; exit 7"}, directory.path());
  EXPECT_EQ(all_of(process), std::filesystem::canonical(directory.path()).string() + "\r\n");
  EXPECT_EQ(process.exit_code(), 7);
}

TEST(ChildProcess, TakesArgumentsAsTheyAre) {
  ChildProcess process({"/bin/echo", "-n", "$HOME 'a' \"b\"; *"}, "/");
  EXPECT_EQ(all_of(process), "$HOME 'a' \"b\"; *");
}

TEST(ChildProcess, StopsBySignals) {
  ChildProcess process({"/bin/sh", "-c", "trap 'echo stopped; exit 130' INT; echo begun; while :; do sleep 0.05; done"},
                       "/");
  std::string text;
  while (text.find("begun") == std::string::npos) text += process.read(milliseconds(100)).value_or("begun");
  process.send(SIGINT);
  EXPECT_NE(all_of(process).find("stopped"), std::string::npos);
  EXPECT_EQ(process.exit_code(), 130);
  process.send(SIGKILL);  // after its end a signal goes nowhere
}

TEST(ChildProcess, IsKilledAtTheEnd) {
  pid_t started = 0;
  {
    ChildProcess process({"/bin/sh", "-c", "echo $$; exec sleep 1000"}, "/");
    std::string text;
    while (text.find('\n') == std::string::npos) text += process.read(milliseconds(100)).value_or("\n");
    started = std::stoi(text);
    EXPECT_EQ(::kill(started, 0), 0);
  }
  EXPECT_NE(::kill(started, 0), 0);
}

TEST(ChildProcess, EndsBySignal) {
  ChildProcess process({"/bin/sh", "-c", "kill -9 $$"}, "/");
  EXPECT_EQ(all_of(process), "");
  EXPECT_EQ(process.exit_code(), 128 + SIGKILL);
}

TEST(ChildProcess, OfAMissingProgramOrDirectoryEndsWith127) {
  ChildProcess nothing({"/no/such/program"}, "/");
  EXPECT_EQ(all_of(nothing), "the program cannot be started in this folder\r\n");
  EXPECT_EQ(nothing.exit_code(), 127);
  ChildProcess nowhere({"/bin/true"}, "/no/such/directory");
  EXPECT_EQ(all_of(nowhere), "the program cannot be started in this folder\r\n");
  EXPECT_EQ(nowhere.exit_code(), 127);
}

}  // namespace
}  // namespace breccia::studio
