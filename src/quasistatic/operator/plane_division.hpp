#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace breccia::quasistatic {

/// The division of the planes of nodes of a box of cubic cells among processes: every process has a slab of whole
/// planes across the third axis, and the slabs differ by a plane at most.
class PlaneDivision {
 public:
  /// The division among so many processes; nothing if there are fewer planes than processes.
  static std::optional<PlaneDivision> among(int processes, int planes);

  [[nodiscard]] int processes() const noexcept { return static_cast<int>(first_.size()) - 1; }
  /// The first plane of a process; for an argument equal to the number of processes, the number of planes.
  [[nodiscard]] int first(int process) const noexcept { return first_[static_cast<std::size_t>(process)]; }
  /// Number of planes of a process.
  [[nodiscard]] int planes(int process) const noexcept { return first(process + 1) - first(process); }

 private:
  explicit PlaneDivision(std::vector<int> first) : first_(std::move(first)) {}

  std::vector<int> first_;  ///< first plane by process, followed by the number of all planes
};

}  // namespace breccia::quasistatic
