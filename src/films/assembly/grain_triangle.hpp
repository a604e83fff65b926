#pragma once

#include <array>
#include <cstddef>

#include "assembly/plane_strain.hpp"
#include "mesh/grain_mesh.hpp"

namespace breccia::films {

/// Gradients of the quadratic shape functions of a triangle of a grain, and its area.
struct TriangleGradients {
  std::array<Gradients, 3> at;  ///< at the three points of integration, of equal weights
  double area;
};

[[nodiscard]] TriangleGradients triangle_gradients(const GrainMesh& mesh, const std::array<std::size_t, 6>& nodes);

}  // namespace breccia::films
