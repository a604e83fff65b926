#include "discretisation/cell_shape.hpp"

#include <cmath>

#include "discretisation/shape_function.hpp"

namespace breccia {

template <int dim>
typename CellShape<dim>::Weights CellShape<dim>::weights(int point) {
  Weights weights{};
  for (std::size_t node = 0; node < weights.size(); ++node) {
    weights[node] = shape_function<dim>(node, offset(point)).weight;
  }
  return weights;
}

template <int dim>
typename CellShape<dim>::StrainMatrix CellShape<dim>::strain_matrix(int point) {
  StrainMatrix strain = StrainMatrix::Zero();
  for (int node = 0; node < nodes; ++node) {
    const auto gradient = shape_function<dim>(static_cast<std::size_t>(node), offset(point)).gradient;
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) {
        // du_i / dx_j adds to the normal strain (i, i) or to the engineering shear (i, j).
        strain(component_index<dim>(i, j), dim * node + i) = gradient[static_cast<std::size_t>(j)];
      }
    }
  }
  return strain;
}

template <int dim>
typename CellShape<dim>::VolumeMatrix CellShape<dim>::volumetric_strain_matrix(int point, Volumetric volumetric) {
  const auto own = [](int p) -> VolumeMatrix { return strain_matrix(p).template topRows<dim>().colwise().sum(); };
  if (volumetric == Volumetric::standard) return own(point);
  VolumeMatrix sum = VolumeMatrix::Zero();
  for (int p = 0; p < points; ++p) sum += own(p);
  return point_volume * sum;
}

template <int dim>
typename CellShape<dim>::StrainMatrix CellShape<dim>::strain_matrix(int point, Volumetric volumetric) {
  auto strain = strain_matrix(point);
  const VolumeMatrix missing =
      volumetric_strain_matrix(point, volumetric) - volumetric_strain_matrix(point, Volumetric::standard);
  strain.template topRows<dim>().rowwise() += missing / static_cast<double>(dim);
  return strain;
}

template <int dim>
typename CellShape<dim>::Stiffness CellShape<dim>::stiffness(const PointModuli& moduli, Volumetric volumetric) {
  // Twice the deviatoric strain energy per unit shear modulus: D = 2 (I - m m^T / 3). In plane strain the out-of-plane
  // strain is zero.
  using Components = Eigen::Matrix<double, strains, strains>;
  Components deviatoric = Components::Identity();
  deviatoric.template topLeftCorner<dim, dim>().setConstant(-2.0 / 3.0);
  deviatoric.template topLeftCorner<dim, dim>().diagonal().setConstant(4.0 / 3.0);
  Stiffness stiffness = Stiffness::Zero();
  for (int p = 0; p < points; ++p) {
    const auto& [bulk, shear] = moduli[static_cast<std::size_t>(p)];
    const auto strain = strain_matrix(p, volumetric);
    const auto volume = volumetric_strain_matrix(p, volumetric);
    stiffness += point_volume * (shear * strain.transpose() * deviatoric * strain + bulk * volume.transpose() * volume);
  }
  return stiffness;
}

template <int dim>
typename CellShape<dim>::Stiffness CellShape<dim>::stiffness(const PointTensors& tensors, Volumetric volumetric) {
  Stiffness stiffness = Stiffness::Zero();
  for (int p = 0; p < points; ++p) {
    const auto strain = strain_matrix(p, volumetric);
    stiffness += point_volume * strain.transpose() * tensors[static_cast<std::size_t>(p)] * strain;
  }
  return stiffness;
}

template <int dim>
typename CellShape<dim>::DeviatorMatrix CellShape<dim>::deviator_matrix() {
  DeviatorMatrix matrix = DeviatorMatrix::Zero();
  if constexpr (dim == 2) {
    matrix.template topLeftCorner<1, 2>() << 1.0, -1.0;
  } else {
    const double root = std::sqrt(1.0 / 3.0);
    matrix.template topLeftCorner<2, 3>() << root, root, -2.0 * root, 1.0, -1.0, 0.0;
  }
  for (int shear = dim; shear < strains; ++shear) matrix(shear - 1, shear) = 1.0;
  return matrix;
}

namespace {

/// The matrix that gives the deviators of all points of a cell, scaled as in CellShape::point_deviators, for nodal
/// displacements.
template <int dim>
auto deviators_of_nodes() {
  using Shape = CellShape<dim>;
  Eigen::Matrix<double, Shape::points * Shape::deviators, Shape::dofs> matrix;
  for (int p = 0; p < Shape::points; ++p) {
    matrix.template middleRows<Shape::deviators>(Shape::deviators * p) =
        std::sqrt(Shape::point_volume) * Shape::deviator_matrix() * Shape::strain_matrix(p, Volumetric::averaged);
  }
  return matrix;
}

}  // namespace

template <int dim>
typename CellShape<dim>::PointDeviators CellShape<dim>::point_deviators() {
  // Gram-Schmidt, twice for full precision.
  const auto of_nodes = deviators_of_nodes<dim>();
  PointDeviators basis = PointDeviators::Zero();
  Eigen::Index found = 0;
  for (const auto& of_node : of_nodes.colwise()) {
    Eigen::Matrix<double, points * deviators, 1> rest = of_node;
    for (int round = 0; round < 2; ++round) rest -= basis * (basis.transpose() * rest);
    constexpr double rounding = 1e-9;
    if (rest.norm() > rounding) basis.col(found++) = rest.normalized();
  }
  return basis;
}

template <int dim>
typename CellShape<dim>::ModeMatrix CellShape<dim>::mode_matrix() {
  ModeMatrix matrix;
  matrix.template topRows<modes - 1>() = point_deviators().transpose() * deviators_of_nodes<dim>();
  matrix.template bottomRows<1>() = volumetric_strain_matrix(0, Volumetric::averaged);
  return matrix;
}

template <int dim>
typename CellShape<dim>::Values CellShape<dim>::affine_motion(const Strain<dim>& strain) {
  Values motion;
  for (int node = 0; node < nodes; ++node) {
    Vector<dim> position{};
    const auto side = corner(node);
    for (std::size_t axis = 0; axis < position.size(); ++axis) position[axis] = side[axis];
    const auto moved = product(strain, position);
    for (int i = 0; i < dim; ++i) motion[dim * node + i] = moved[static_cast<std::size_t>(i)];
  }
  return motion;
}

template struct CellShape<2>;
template struct CellShape<3>;

}  // namespace breccia
