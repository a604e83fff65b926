#pragma once

#include <filesystem>

namespace breccia::parallel {

/// Memory [B] that this process may still allocate: the smallest of the free memory of the machine, the limits of its
/// control groups and that of `ulimit -v`; infinite if none of them can be read.
double available_memory();

/// Memory [B] that a process may still allocate under the limits of its control groups, of version 1 or 2 and with any
/// nesting; infinite without a limit. `membership` is the file `/proc/<pid>/cgroup` of the process, `root` the mount
/// point of the groups.
double left_in_control_groups(const std::filesystem::path& membership, const std::filesystem::path& root);

}  // namespace breccia::parallel
