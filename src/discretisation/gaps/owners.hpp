#pragma once

#include <cstdint>
#include <vector>

#include "discretisation/gaps/particle_images.hpp"

namespace breccia::gaps {

/// The owners of the nodes of a grid. A node in a particle belongs to it. A node in a narrow gap belongs to the nearer
/// of both particles, though it lies in binder, so that cells do not see the motion of the binder in the gap as a
/// motion of their nodes. Nodes on walls belong to the walls. All other nodes are free, and those outside a box that is
/// not periodic.
template <int dim>
class Owners {
 public:
  /// Nodes lie up to ParticleImages::margin() cells outside the box.
  explicit Owners(const ParticleImages<dim>& images);

  /// The particle to which a node belongs, or walls; no_image for a free one.
  [[nodiscard]] ImageIndex of(const Index<dim>& node) const noexcept {
    return range_.contains(node) ? nodes_[range_.place_of(node)].owner : no_image;
  }
  [[nodiscard]] bool is_free(const Index<dim>& node) const noexcept { return of(node) == no_image; }
  [[nodiscard]] bool is_in_binder(const Index<dim>& node) const noexcept {
    return !range_.contains(node) || nodes_[range_.place_of(node)].is_in_binder;
  }

 private:
  struct Node {
    ImageIndex owner = no_image;
    bool is_in_binder = true;
  };
  IndexRange<dim> range_;
  std::vector<Node> nodes_;
};

extern template class Owners<2>;
extern template class Owners<3>;

}  // namespace breccia::gaps
