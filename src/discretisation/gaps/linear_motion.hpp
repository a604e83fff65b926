#pragma once

#include <Eigen/Core>

#include "discretisation/gaps/gap_cell.hpp"

namespace breccia::gaps {

/// The unknowns of a cell in a displacement with this gradient everywhere, without flow; the lowest node is at rest.
template <int dim>
[[nodiscard]] CellUnknowns<dim> linear_motion(const Eigen::Matrix<double, dim, dim>& gradient) noexcept;

}  // namespace breccia::gaps
