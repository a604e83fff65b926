#include "parallel/available_memory.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include <sys/resource.h>

namespace breccia::parallel {
namespace {

namespace fs = std::filesystem;

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double kibibyte = 1024.0;

/// The number after a word at the beginning of a line of a file of the kernel, such as `MemAvailable:`.
std::optional<double> number_after(const fs::path& file, const std::string& word) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(word)) continue;
    const auto begin = line.find_first_of("0123456789", word.size());
    if (begin == std::string::npos) return std::nullopt;
    double number = 0.0;
    std::from_chars(line.data() + begin, line.data() + line.size(), number);
    return number;
  }
  return std::nullopt;
}

double left_on_machine() {
  const auto available = number_after("/proc/meminfo", "MemAvailable:");
  return available ? kibibyte * *available : unlimited;
}

double left_of_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  // Memory that is left to the libraries for MPI and linear algebra [B]: with less they fail, or wait forever.
  constexpr double of_libraries = 4e8;
  const auto used = number_after("/proc/self/status", "VmSize:");
  return static_cast<double>(limit.rlim_cur) - kibibyte * used.value_or(0.0) - of_libraries;
}

/// The files with the limit and the use of a control group, for one version of control groups.
struct GroupFiles {
  const char* limit;
  const char* used;
  const char* inactive;  // line of memory.stat with the memory of files that the kernel can free
};

double left_in_group(const fs::path& group, const GroupFiles& files) {
  const auto limit = number_after(group / files.limit, "");
  const auto used = number_after(group / files.used, "");
  const auto given_back = number_after(group / "memory.stat", files.inactive);
  return limit && used ? *limit - *used + given_back.value_or(0.0) : unlimited;
}

/// The memory left in a group and in all groups that contain it, up to the root.
double left_in_groups(const fs::path& root, const fs::path& name, const GroupFiles& files) {
  double least = left_in_group(root, files);
  auto group = root;
  for (const auto& part : name.relative_path()) {
    group /= part;
    least = std::min(least, left_in_group(group, files));
  }
  return least;
}

}  // namespace

double left_in_control_groups(const fs::path& membership, const fs::path& root) {
  double least = unlimited;
  std::ifstream stream(membership);
  for (std::string line; std::getline(stream, line);) {
    // The line has the form number:controllers:name, in version 2 without controllers.
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const auto controllers = line.substr(first + 1, second - first - 1), name = line.substr(second + 1);
    if (controllers.empty()) {
      least = std::min(least, left_in_groups(root, name, {"memory.max", "memory.current", "inactive_file"}));
    } else if (controllers == "memory") {
      least =
          std::min(least, left_in_groups(root / "memory", name,
                                         {"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"}));
    }
  }
  return least;
}

double available_memory() {
  return std::min(
      {left_on_machine(), left_in_control_groups("/proc/self/cgroup", "/sys/fs/cgroup"), left_of_address_space()});
}

}  // namespace breccia::parallel
