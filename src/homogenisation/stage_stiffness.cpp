#include "breccia/homogenisation/stage_stiffness.hpp"

#include <cstddef>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "breccia/discretisation/crystals.hpp"
#include "breccia/error.hpp"

namespace breccia {
namespace {

template <int dim>
StiffnessTensor<dim> from_upper_triangle(std::span<const double> constants) {
  StiffnessTensor<dim> stiffness;
  std::size_t next = 0;
  for (int i = 0; i < tensor_components<dim>; ++i) {
    for (int j = i; j < tensor_components<dim>; ++j) stiffness(i, j) = stiffness(j, i) = constants[next++];
  }
  return stiffness;
}

template <int dim>
IsotropicPart isotropic_part_of(const StiffnessTensor<dim>& stiffness) {
  constexpr int shears = tensor_components<dim> - 1;
  const auto orthonormal = in_orthonormal_basis<dim>(stiffness);
  Eigen::Vector<double, tensor_components<dim>> dilatation;
  dilatation.setZero();
  dilatation.template head<dim>().setOnes();
  const double volumetric = dilatation.dot(orthonormal * dilatation) / dim;
  const double deviatoric = (orthonormal.trace() - volumetric) / shears;
  IsotropicPart part = {.bulk = volumetric / dim, .shear = 0.5 * deviatoric};
  if constexpr (dim == 2) part.bulk -= part.shear / 3.0;
  const Eigen::LLT<StiffnessTensor<dim>> factors(orthonormal);
  if (factors.info() != Eigen::Success) return part;
  const StiffnessTensor<dim> compliance = factors.solve(StiffnessTensor<dim>::Identity());
  const double of_volume = dilatation.dot(compliance * dilatation) / dim;
  const double of_deviators = (compliance.trace() - of_volume) / shears;
  part.anisotropy = shears * (deviatoric * of_deviators - 1.0) + (volumetric * of_volume - 1.0);
  return part;
}

}  // namespace

IsotropicPart isotropic_part(std::span<const double> constants) {
  constexpr std::size_t of_plane = 6, of_space = 21;
  if (constants.size() == of_plane) return isotropic_part_of<2>(from_upper_triangle<2>(constants));
  if (constants.size() == of_space) return isotropic_part_of<3>(from_upper_triangle<3>(constants));
  throw InputError(fmt::format("a stiffness has 6 constants in the plane and 21 in space, got {}", constants.size()));
}

}  // namespace breccia
