#include "assembly/grain_stiffness.hpp"

#include <array>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "assembly/plane_strain.hpp"
#include "assembly/quadratic_triangle.hpp"

namespace breccia::films {
namespace {

/// Components of the displacements of all nodes, and of those of the boundary, which come first.
struct Sizes {
  Eigen::Index all, outer;
  explicit Sizes(const GrainMesh& mesh)
      : all(2 * static_cast<Eigen::Index>(mesh.nodes.size())),
        outer(2 * static_cast<Eigen::Index>(mesh.boundary_nodes)) {}
  [[nodiscard]] Eigen::Index inner() const noexcept { return all - outer; }
};

/// Stiffness for displacements of all nodes.
Eigen::MatrixXd whole_stiffness(const GrainMesh& mesh, const Moduli& moduli) {
  const auto elasticity = plane_strain_stiffness(moduli);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(Sizes(mesh).all, Sizes(mesh).all);
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
  return whole;
}

}  // namespace

Eigen::MatrixXd grain_stiffness(const GrainMesh& mesh, const Moduli& moduli) {
  const Sizes size(mesh);
  const auto whole = whole_stiffness(mesh, moduli);
  const Eigen::LLT<Eigen::MatrixXd> inside(whole.bottomRightCorner(size.inner(), size.inner()));
  const Eigen::MatrixXd coupling = inside.matrixL().solve(whole.bottomLeftCorner(size.inner(), size.outer));
  Eigen::MatrixXd condensed = whole.topLeftCorner(size.outer, size.outer);
  condensed.noalias() -= coupling.transpose() * coupling;
  return condensed;
}

Eigen::VectorXd grain_displacements(const GrainMesh& mesh, const Moduli& moduli, const Eigen::VectorXd& boundary) {
  const Sizes size(mesh);
  const auto whole = whole_stiffness(mesh, moduli);
  const Eigen::LLT<Eigen::MatrixXd> inside(whole.bottomRightCorner(size.inner(), size.inner()));
  Eigen::VectorXd displacements(size.all);
  displacements << boundary, -inside.solve(whole.bottomLeftCorner(size.inner(), size.outer) * boundary);
  return displacements;
}

}  // namespace breccia::films
