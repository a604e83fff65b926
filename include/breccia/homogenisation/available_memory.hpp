#pragma once

#include <filesystem>

namespace breccia {

/// Memory [B] that this process may still take: what the machine has left, the limits of its control groups and that of
/// `ulimit -v`, whichever is least; infinite where none can be read.
double available_memory();

/// Memory [B] that the control groups of a process leave it, of either version and however deep they are nested;
/// infinite where none limits it. `membership` is its /proc/<pid>/cgroup, `root` where the groups are mounted.
double left_in_control_groups(const std::filesystem::path& membership, const std::filesystem::path& root);

}  // namespace breccia
