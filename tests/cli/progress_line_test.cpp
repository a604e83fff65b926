#include "cli/progress_line.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/heartbeat.hpp"
#include "io/text_file.hpp"
#include "temporary_directory.hpp"

namespace breccia::cli {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

constexpr milliseconds short_while(1);

/// A file in the place of a terminal.
class ProgressTest : public testing::Test {
 protected:
  [[nodiscard]] std::string shown() const { return read_text(file); }
  /// Waits until so many lines have been written, without a time limit.
  void wait_for_lines(std::ptrdiff_t count) const {
    for (auto text = shown(); std::ranges::count(text, '\n') < count; text = shown()) {
      std::this_thread::sleep_for(short_while);
    }
  }

  test::TemporaryDirectory directory;
  std::filesystem::path file = directory.path() / "lines";
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{std::fopen(file.c_str(), "w"), std::fclose};
};

TEST_F(ProgressTest, PrintsLinesDuringLongSteps) {
  ProgressLine progress(false, stream.get(), {short_while, short_while});
  progress.update("HB-1 displacement", 0.25, "snapshot 3");
  wait_for_lines(3);
  const auto text = shown();
  EXPECT_THAT(text, testing::StartsWith("HB-1 displacement: 25 %, snapshot 3, "));
  EXPECT_THAT(text, HasSubstr(" so far, "));
  EXPECT_THAT(text, HasSubstr(" left\n"));
}

TEST_F(ProgressTest, EstimatesNoRemainingTimeAtTheBeginning) {
  ProgressLine progress(false, stream.get(), {short_while, short_while});
  progress.update("HB-1 displacement", 0.0, "begun");
  wait_for_lines(1);
  EXPECT_THAT(shown(), testing::Not(HasSubstr("left")));
}

TEST_F(ProgressTest, ShowsTheLatestUpdate) {
  ProgressLine progress(false, stream.get(), {short_while, short_while});
  progress.update("HB-1 displacement", 0.5, "snapshot 5");
  progress.update("HB-1 traction", 0.1, "snapshot 1");
  wait_for_lines(1);
  EXPECT_THAT(shown(), testing::StartsWith("HB-1 traction: 10 %, snapshot 1, "));
}

TEST_F(ProgressTest, PrintsNothingWhenQuiet) {
  {
    ProgressLine progress(true, stream.get(), {milliseconds(0), short_while});
    progress.update("HB-1 displacement", 0.5, "snapshot 5");
    std::this_thread::sleep_for(10 * short_while);
  }
  EXPECT_EQ(shown(), "");
}

TEST_F(ProgressTest, PrintsNothingBeforeALineIsDue) {
  {
    ProgressLine progress(false, stream.get(), {std::chrono::hours(1), short_while});
    progress.update("HB-1 displacement", 0.5, "snapshot 5");
    std::this_thread::sleep_for(10 * short_while);
  }
  EXPECT_EQ(shown(), "");
}

TEST(Heartbeat, BeatsUntilItIsDestroyed) {
  std::atomic<int> beats = 0;
  {
    const Heartbeat heartbeat(short_while, [&beats] { ++beats; });
    while (beats < 3) std::this_thread::sleep_for(short_while);
  }
  const int last = beats;
  std::this_thread::sleep_for(10 * short_while);
  EXPECT_EQ(beats, last);
}

TEST(Heartbeat, EndsAtOnce) {
  // Without an early end the test would take an hour.
  const Heartbeat heartbeat(std::chrono::hours(1), [] {});
}

}  // namespace
}  // namespace breccia::cli
