#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "breccia/microstructure/laguerre_sites.hpp"

namespace breccia::films {

/// Numbers nodes by their positions, so that elements that meet share nodes. In a periodic box a node and its images
/// have one number. Lengths are in sides of the box; positions closer than 1e-10 count as equal.
template <int dim>
class NodeMerger {
 public:
  using Position = Eigen::Matrix<double, dim, 1>;

  explicit NodeMerger(Walls walls) : is_periodic_(walls == Walls::periodic) {}

  /// The number of the node at a position.
  [[nodiscard]] std::size_t number(const Position& position);
  /// The positions of the nodes, each as it was first given.
  [[nodiscard]] const std::vector<Position>& positions() const noexcept { return positions_; }

 private:
  using Square = std::array<std::int64_t, static_cast<std::size_t>(dim)>;

  bool is_periodic_;
  std::vector<Position> positions_, in_box_;
  std::map<Square, std::vector<std::size_t>> in_square_;  ///< the nodes in each square or cube of a fine grid
};

}  // namespace breccia::films
