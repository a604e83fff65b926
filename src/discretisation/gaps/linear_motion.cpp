#include "discretisation/gaps/linear_motion.hpp"

#include "discretisation/gaps/plane/cell_place.hpp"
#include "discretisation/gaps/space/cube_unknowns.hpp"

namespace breccia::gaps {
namespace {

void set_slopes(const Eigen::Matrix2d& gradient, CellUnknowns<2>& motion) noexcept {
  for (int face = 0; face < faces_of_cell<2>; ++face) {
    const auto normal = static_cast<Eigen::Index>(CellPlace::normal(face));
    for (int end = 0; end < 2; ++end) motion[slope_at(face, end)] = gradient(normal, 1 - normal);
  }
}

void set_slopes(const Eigen::Matrix3d& gradient, CellUnknowns<3>& motion) noexcept {
  for (int node = 0; node < CellShape<3>::nodes; ++node) {
    for (const auto& slope : slopes_of_node) {
      motion[slope_at(node, slope)] =
          gradient(static_cast<Eigen::Index>(slope.component), static_cast<Eigen::Index>(slope.along));
    }
  }
}

}  // namespace

template <int dim>
CellUnknowns<dim> linear_motion(const Eigen::Matrix<double, dim, dim>& gradient) noexcept {
  CellUnknowns<dim> motion = CellUnknowns<dim>::Zero();
  for (int node = 0; node < CellShape<dim>::nodes; ++node) {
    const auto corner = CellShape<dim>::corner(node);
    Eigen::Matrix<double, dim, 1> place;
    for (std::size_t axis = 0; axis < corner.size(); ++axis) place[static_cast<Eigen::Index>(axis)] = corner[axis];
    motion.template segment<dim>(dim * node) = gradient * place;
  }
  set_slopes(gradient, motion);
  return motion;
}

template CellUnknowns<2> linear_motion<2>(const Eigen::Matrix2d&) noexcept;
template CellUnknowns<3> linear_motion<3>(const Eigen::Matrix3d&) noexcept;

}  // namespace breccia::gaps
