#include "films/space/solid_unknowns.hpp"

#include <cstddef>

#include "films/assembly/macroscopic.hpp"

namespace breccia::films {

ElementUnknowns<3> solid_unknowns(std::span<const ElementNode> nodes, std::span<const int> others) {
  ElementUnknowns<3> unknowns;
  unknowns.macroscopic.setZero(static_cast<Eigen::Index>(3 * nodes.size() + others.size()), 6);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    unknowns.macroscopic.middleRows<3>(3 * static_cast<Eigen::Index>(n)) =
        affine_motion_in_space(nodes[n].position - nodes[0].position);
    for (int i = 0; i < 3; ++i) {
      unknowns.numbers.push_back(nodes[n].number == 0 ? held : displacements_of(nodes[n].number) + i);
    }
  }
  unknowns.numbers.insert(unknowns.numbers.end(), others.begin(), others.end());
  return unknowns;
}

}  // namespace breccia::films
