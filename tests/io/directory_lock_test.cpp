#include "io/directory_lock.hpp"

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Lock : public testing::Test {
 protected:
  [[nodiscard]] fs::path directory() const { return place_.path() / "out"; }

  test::TemporaryDirectory place_;
};

TEST_F(Lock, IsHeldByOneAtATime) {
  const DirectoryLock lock(directory());
  EXPECT_THAT(test::message_of<DirectoryInUse>([&] { const DirectoryLock other(directory()); }),
              HasSubstr("out: another process of Breccia writes its results here"));
  EXPECT_TRUE(fs::exists(directory())) << "the refused one must not remove it";
}

TEST_F(Lock, EndsWithItsHolderAndLeavesNoEmptyDirectory) {
  try {
    const DirectoryLock lock(directory());
    throw std::runtime_error("a run that fails");
  } catch (const std::runtime_error&) {
    EXPECT_FALSE(fs::exists(directory()));
  }
  {
    const DirectoryLock again(directory());
    place_.write("out/curves.csv", "mine");
  }
  EXPECT_TRUE(fs::exists(directory() / "curves.csv"));
}

TEST_F(Lock, LeavesSymbolicLinksToTheDirectory) {
  fs::create_directory(place_.path() / "disk");
  fs::create_directory_symlink("disk", directory());
  {
    const DirectoryLock lock(directory());
    EXPECT_THROW(const DirectoryLock other(place_.path() / "disk"), DirectoryInUse) << "the same by another path";
  }
  EXPECT_TRUE(fs::is_symlink(directory()));
  EXPECT_TRUE(fs::is_directory(place_.path() / "disk"));
}

TEST_F(Lock, OfSomethingElseIsAFileError) {
  place_.write("out", "a file");
  EXPECT_THROW(const DirectoryLock lock(directory()), FileError);
  fs::remove(directory());
  fs::create_directory_symlink("nowhere", directory());
  EXPECT_THROW(const DirectoryLock lock(directory()), FileError);
}

/// The directory is empty, so that each holder removes it when it ends. Processes that have opened it by then wait for
/// a directory that does not exist any more.
TEST_F(Lock, LocksTheDirectoryThatThePathRefersTo) {
  constexpr int threads = 4, attempts = 1500;
  std::atomic<int> holders = 0, held = 0, mistakes = 0;
  const auto attempt = [&] {
    for (int i = 0; i < attempts; ++i) {
      try {
        const DirectoryLock lock(directory());
        if (++holders != 1 || !fs::exists(directory())) ++mistakes;
        std::this_thread::yield();
        ++held;
        --holders;
      } catch (const DirectoryInUse&) {
        std::this_thread::yield();
      }
    }
  };
  {
    std::vector<std::jthread> all;
    all.reserve(threads);
    for (int i = 0; i < threads; ++i) all.emplace_back(attempt);
  }
  EXPECT_EQ(mistakes, 0);
  EXPECT_GT(held, 0);
  EXPECT_FALSE(fs::exists(directory()));
}

}  // namespace
}  // namespace breccia
