#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "films/space/cell_complex.hpp"
#include "films/space/sheet_mesh.hpp"
#include "films/space/shrunk_grains.hpp"

namespace breccia::films {

/// A grain as tetrahedra with straight edges and ten nodes each, from the triangles of its faces to its centre.
struct GrainSolid {
  std::vector<Eigen::Vector3d> nodes;  ///< positions, in sides of the box
  /// Four corners, of a positive volume; then the middles of the edges (edges_of_tetrahedron).
  std::vector<std::array<std::size_t, 10>> tetrahedra;
};

/// A node of a grain that is displaced by whole sides of the box.
struct SolidNode {
  std::size_t grain = 0, number = 0;
  Eigen::Vector3i image;  ///< sides of the box
};

/// The grains as solids, whose surfaces have the nodes of the sheets.
class GrainSolids {
 public:
  GrainSolids(const CellComplex& complex, const SheetMesh& sheets, const std::vector<ShrunkGrain>& grains);

  [[nodiscard]] const std::vector<GrainSolid>& solids() const noexcept { return solids_; }
  /// The node of a grain, displaced by whole sides, beside a node of the sheets.
  [[nodiscard]] SolidNode beside(const CellImage& grain, const SheetNode& node) const;
  [[nodiscard]] Eigen::Vector3d position(const SolidNode& node) const {
    return solids_[node.grain].nodes[node.number] + node.image.cast<double>();
  }

 private:
  using Key = std::pair<std::size_t, std::array<int, 3>>;  ///< node of the sheets and displacement from the grain

  std::vector<GrainSolid> solids_;
  std::vector<std::map<Key, std::size_t>> number_;  ///< node on the surface, by grain
};

}  // namespace breccia::films
