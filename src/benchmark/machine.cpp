#include "benchmark/machine.hpp"

#include <fstream>

#include <fmt/format.h>
#include <omp.h>

namespace breccia {
namespace {

/// Value of the first line `model name : value` in /proc/cpuinfo.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const auto value = line.find_first_not_of(" \t", line.find(':') + 1);
    return value == std::string::npos ? "" : line.substr(value);
  }
  return {};
}

/// Linux lists the caches that a core uses from the first level up, each with its size in KiB.
double last_level_of_cache() {
  double last = 0.0;
  for (int cache = 0;; ++cache) {
    std::ifstream file(fmt::format("/sys/devices/system/cpu/cpu0/cache/index{}/size", cache));
    double kibibytes = 0.0;
    if (!(file >> kibibytes)) return last;
    last = 1024.0 * kibibytes;
  }
}

}  // namespace

Machine this_machine() {
  return {processor_name(), omp_get_num_procs(), last_level_of_cache()};
}

}  // namespace breccia
