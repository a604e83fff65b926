#pragma once

#include <Eigen/Core>

#include "breccia/discretisation/moduli.hpp"

#include "mesh/grain_mesh.hpp"

namespace breccia::films {

/// Stiffness of an elastic grain for displacements of the nodes of its boundary, two components a node [Pa]: the nodes
/// inside, on which nothing acts, are eliminated. In plane strain, of unit thickness; lengths cancel.
[[nodiscard]] Eigen::MatrixXd grain_stiffness(const GrainMesh& mesh, const Moduli& moduli);

/// Displacements of all nodes of such a grain, two components a node, for those of the nodes of its boundary.
[[nodiscard]] Eigen::VectorXd grain_displacements(const GrainMesh& mesh, const Moduli& moduli,
                                                  const Eigen::VectorXd& boundary);

}  // namespace breccia::films
