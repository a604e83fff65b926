#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "breccia/discretisation/crystals.hpp"
#include "breccia/discretisation/moduli.hpp"
#include "breccia/discretisation/tensor.hpp"
#include "breccia/discretisation/volumetric.hpp"
#include "breccia/microstructure/index.hpp"

namespace breccia {

/// A square or cubic cell with a node in every corner and 2^dim material points at +-1/4 of its side from its centre.
/// Bit d of the number of a node or a point says whether it lies on the upper side along axis d: lower left, lower
/// right, upper left, upper right in 2D. Lengths are in units of the cell side h.
template <int dim>
struct CellShape {
  static constexpr int nodes = 1 << dim;
  static constexpr int points = 1 << dim;
  static constexpr int dofs = dim * nodes;  ///< the components of the first node, then those of the second, ...
  static constexpr int strains = tensor_components<dim>;
  /// Independent components of a strain without its equal normal strains.
  static constexpr int deviators = strains - 1;
  /// Number of strain modes: motions of the nodes without the rigid ones.
  static constexpr int modes = dofs - dim * (dim + 1) / 2;
  static constexpr double point_volume = 1.0 / points;  ///< share of a point in the volume of the cell

  using Weights = std::array<double, std::size_t{1} << dim>;                     ///< weights by node
  using PointModuli = std::array<Moduli, std::size_t{1} << dim>;                 ///< moduli by point
  using PointTensors = std::array<StiffnessTensor<dim>, std::size_t{1} << dim>;  ///< stiffnesses by point
  using Values = Eigen::Matrix<double, dofs, 1>;                                 ///< nodal displacements or forces
  using Stiffness = Eigen::Matrix<double, dofs, dofs>;
  using StrainVector = Eigen::Matrix<double, strains, 1>;
  using StrainMatrix = Eigen::Matrix<double, strains, dofs>;
  using VolumeMatrix = Eigen::Matrix<double, 1, dofs>;
  using DeviatorMatrix = Eigen::Matrix<double, deviators, strains>;
  using PointDeviators = Eigen::Matrix<double, points * deviators, modes - 1>;
  using ModeValues = Eigen::Matrix<double, modes, 1>;
  using ModeMatrix = Eigen::Matrix<double, modes, dofs>;

  /// The corner of the cell at which a node is; each coordinate is 0 or 1.
  [[nodiscard]] static constexpr Index<dim> corner(int node) noexcept {
    Index<dim> corner{};
    for (int axis = 0; axis < dim; ++axis) corner[static_cast<std::size_t>(axis)] = (node >> axis) & 1;
    return corner;
  }
  /// Position of a point relative to the centre of the cell.
  [[nodiscard]] static constexpr Vector<dim> offset(int point) noexcept {
    Vector<dim> offset{};
    const auto side = corner(point);
    for (std::size_t axis = 0; axis < offset.size(); ++axis) offset[axis] = 0.5 * side[axis] - 0.25;
    return offset;
  }

  /// Weights of the nodes at a point; in 2D 9/16, 3/16, 3/16 and 1/16 in the point's order.
  [[nodiscard]] static Weights weights(int point);

  /// Strain at a point from the nodal displacements, with engineering shears in Voigt's order (theory, Eq. 3).
  [[nodiscard]] static StrainMatrix strain_matrix(int point);
  /// The strain that the stress of the point depends on: its volumetric part is that of the point itself (full
  /// integration) or the mean of the cell (B-bar; theory, Eq. 4).
  [[nodiscard]] static StrainMatrix strain_matrix(int point, Volumetric volumetric);
  /// Sum of the normal components of that strain.
  [[nodiscard]] static VolumeMatrix volumetric_strain_matrix(int point, Volumetric volumetric);

  /// Stiffness of a cell [Pa]: for nodal displacements [m] it gives the nodal forces [N] (in 2D per unit thickness
  /// [N/m]) divided by h^(dim-2) (theory, Eq. 5).
  [[nodiscard]] static Stiffness stiffness(const PointModuli& moduli, Volumetric volumetric);
  /// The stiffness of a cell of points with these full stiffnesses.
  [[nodiscard]] static Stiffness stiffness(const PointTensors& tensors, Volumetric volumetric);

  /// The matrix L that gives the deviator L e of a strain e, its part without equal strains along all axes, scaled so
  /// that |L e|^2 is twice its energy per unit shear modulus. L' gives the stress components of such a deviator times a
  /// modulus.
  [[nodiscard]] static DeviatorMatrix deviator_matrix();
  /// The deviators of the points, point by point and times the square root of point_volume, for unit modes: an
  /// orthonormal basis of the deviators that displacements of the nodes can cause.
  [[nodiscard]] static PointDeviators point_deviators();
  /// The modes of a cell with averaged volumetric strains: coordinates of the deviators of its points in that basis,
  /// then the mean sum of the normal strains. With one material, twice the energy is the dilatational modulus times the
  /// square of the last mode plus the shear modulus times the squares of all other modes (theory, Eq. 41).
  [[nodiscard]] static ModeMatrix mode_matrix();

  /// Displacements of the nodes under a uniform strain, with node 0 at rest.
  [[nodiscard]] static Values affine_motion(const Strain<dim>& strain);
};

extern template struct CellShape<2>;
extern template struct CellShape<3>;

}  // namespace breccia
