#include "parallel/available_memory.hpp"

#include <filesystem>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "temporary_directory.hpp"

namespace breccia::parallel {
namespace {

TEST(AvailableMemory, IsMoreThanThatOfThisProgram) {
  EXPECT_GT(available_memory(), 1e6);
}

/// Control groups in the form in which the kernel shows them.
class ControlGroups : public testing::Test {
 protected:
  void group(const std::string& path, const std::string& limit_file, const std::string& limit,
             const std::string& used_file, const std::string& used, const std::string& statistics) const {
    std::filesystem::create_directories(directory_.path() / path);
    directory_.write(path + "/" + limit_file, limit + "\n");
    directory_.write(path + "/" + used_file, used + "\n");
    directory_.write(path + "/memory.stat", statistics);
  }
  [[nodiscard]] double left(const std::string& membership) const {
    return left_in_control_groups(directory_.written("membership", membership), directory_.path());
  }

 private:
  test::TemporaryDirectory directory_;
};

TEST_F(ControlGroups, OfVersion2LeaveTheLeastOnTheWayUp) {
  group("job", "memory.max", "8000000000", "memory.current", "5000000000", "anon 1\ninactive_file 1000000000\n");
  group("job/step", "memory.max", "max", "memory.current", "1000", "inactive_file 0\n");
  group("job/step/task", "memory.max", "6000000000", "memory.current", "1000000000", "");
  EXPECT_EQ(left("0::/job/step/task\n"), 4e9);
  EXPECT_EQ(left("0::/job/step\n"), 4e9);
  EXPECT_EQ(left("0::/\n"), std::numeric_limits<double>::infinity());
}

TEST_F(ControlGroups, OfAContainerAreTheRoot) {
  group(".", "memory.max", "2000000000", "memory.current", "500000000", "inactive_file 100000000\n");
  EXPECT_EQ(left("0::/\n"), 1.6e9);
}

TEST_F(ControlGroups, OfVersion1AreFoundAmongTheOthers) {
  group("memory/job", "memory.limit_in_bytes", "3000000000", "memory.usage_in_bytes", "1000000000",
        "inactive_file 7\ntotal_inactive_file 500000000\n");
  EXPECT_EQ(left("9:name=systemd:/\n4:memory:/job\n0::/\n"), 2.5e9);
  EXPECT_EQ(left("4:memory:/elsewhere\nnonsense\n"), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace breccia::parallel
