#include "assembly/grain_stiffness.hpp"

#include <cstddef>

#include <Eigen/Cholesky>

#include "assembly/plane_strain.hpp"
#include "assembly/quadratic_triangle.hpp"

namespace breccia::films {

Eigen::MatrixXd grain_stiffness(const GrainMesh& mesh, const Moduli& moduli) {
  const auto size = 2 * static_cast<Eigen::Index>(mesh.nodes.size());
  const auto outer = 2 * static_cast<Eigen::Index>(mesh.boundary_nodes), inner = size - outer;
  const auto elasticity = plane_strain_stiffness(moduli);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(size, size);
  for (const auto& nodes : mesh.triangles) {
    const auto element = triangle_stiffness(
        quadratic_triangle({mesh.nodes[nodes[0]], mesh.nodes[nodes[1]], mesh.nodes[nodes[2]]}), elasticity);
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        whole.block<2, 2>(2 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(i)]),
                          2 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(j)])) +=
            element.block<2, 2>(2 * i, 2 * j);
      }
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> inside(whole.bottomRightCorner(inner, inner));
  const Eigen::MatrixXd coupling = inside.matrixL().solve(whole.bottomLeftCorner(inner, outer));
  Eigen::MatrixXd condensed = whole.topLeftCorner(outer, outer);
  condensed.noalias() -= coupling.transpose() * coupling;
  return condensed;
}

}  // namespace breccia::films
