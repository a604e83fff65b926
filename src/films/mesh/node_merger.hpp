#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "breccia/microstructure/laguerre_sites.hpp"

namespace breccia::films {

/// Numbers nodes by their positions, so that elements that meet share nodes. In a periodic box a node and its images
/// have one number. Lengths are in sides of the box; positions closer than 1e-10 count as equal.
class NodeMerger {
 public:
  explicit NodeMerger(Walls walls) : is_periodic_(walls == Walls::periodic) {}

  /// The number of the node at a position.
  [[nodiscard]] std::size_t number(const Eigen::Vector2d& position);
  /// The positions of the nodes, each as it was first given.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& positions() const noexcept { return positions_; }

 private:
  using Square = std::pair<std::int64_t, std::int64_t>;

  bool is_periodic_;
  std::vector<Eigen::Vector2d> positions_, in_box_;
  std::map<Square, std::vector<std::size_t>> in_square_;  ///< the nodes in each square of a fine grid
};

}  // namespace breccia::films
