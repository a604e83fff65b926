#pragma once

#include <array>
#include <cstddef>

#include "breccia/microstructure/vector.hpp"

namespace breccia {

/// Number of the components of a symmetric tensor. The normal components come first, then the shears.
template <int dim>
constexpr int tensor_components = dim*(dim + 1) / 2;

/// A symmetric tensor in `dim` dimensions, its components in Voigt's order. `Quantity` keeps strains and stresses
/// apart.
template <int dim, class Quantity>
struct SymmetricTensor;

template <class Quantity>
struct SymmetricTensor<2, Quantity> {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;

  friend bool operator==(const SymmetricTensor&, const SymmetricTensor&) = default;
};

template <class Quantity>
struct SymmetricTensor<3, Quantity> {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double yz = 0.0;
  double zx = 0.0;
  double xy = 0.0;

  friend bool operator==(const SymmetricTensor&, const SymmetricTensor&) = default;
};

/// Small strain [-]. Shears are tensor components, half of the engineering shears. In 2D the strain is plane: the
/// out-of-plane strain is zero.
template <int dim>
using Strain = SymmetricTensor<dim, struct StrainQuantity>;

/// Stress, tension positive [Pa].
template <int dim>
using Stress = SymmetricTensor<dim, struct StressQuantity>;

/// Index of the component (i, j) in Voigt's order; axes count from 0.
template <int dim>
[[nodiscard]] constexpr int component_index(int i, int j) noexcept {
  // The shears are in the order of the axes normal to their planes: yz, zx, xy.
  return i == j ? i : tensor_components<dim> - i - j;
}

/// The component with an index in Voigt's order.
template <class Quantity>
[[nodiscard]] constexpr double& component(SymmetricTensor<2, Quantity>& t, int index) noexcept {
  return index == 0 ? t.xx : index == 1 ? t.yy : t.xy;
}
template <class Quantity>
[[nodiscard]] constexpr double& component(SymmetricTensor<3, Quantity>& t, int index) noexcept {
  switch (index) {
    case 0:
      return t.xx;
    case 1:
      return t.yy;
    case 2:
      return t.zz;
    case 3:
      return t.yz;
    case 4:
      return t.zx;
    default:
      return t.xy;
  }
}
template <int dim, class Quantity>
[[nodiscard]] constexpr double component(const SymmetricTensor<dim, Quantity>& t, int index) noexcept {
  auto copy = t;
  return component(copy, index);
}

/// The component (i, j).
template <int dim, class Quantity>
[[nodiscard]] constexpr double component(const SymmetricTensor<dim, Quantity>& t, int i, int j) noexcept {
  return component(t, component_index<dim>(i, j));
}

/// The double contraction a : b, the sum over all pairs (i, j) of a_ij b_ij.
template <int dim, class A, class B>
[[nodiscard]] constexpr double contraction(const SymmetricTensor<dim, A>& a,
                                           const SymmetricTensor<dim, B>& b) noexcept {
  double sum = component(a, 0) * component(b, 0);
  for (int index = 1; index < tensor_components<dim>; ++index) {
    const double times = index < dim ? 1.0 : 2.0;
    sum += times * component(a, index) * component(b, index);
  }
  return sum;
}

/// The tensor times a vector.
template <int dim, class Quantity>
[[nodiscard]] constexpr Vector<dim> product(const SymmetricTensor<dim, Quantity>& t, const Vector<dim>& x) noexcept {
  Vector<dim> result{};
  for (int i = 0; i < dim; ++i) {
    double sum = component(t, i, 0) * x[0];
    for (int j = 1; j < dim; ++j) sum += component(t, i, j) * x[static_cast<std::size_t>(j)];
    result[static_cast<std::size_t>(i)] = sum;
  }
  return result;
}

/// The tensor times a number.
template <int dim, class Quantity>
[[nodiscard]] constexpr SymmetricTensor<dim, Quantity> scaled(double factor,
                                                              SymmetricTensor<dim, Quantity> t) noexcept {
  for (int index = 0; index < tensor_components<dim>; ++index) component(t, index) *= factor;
  return t;
}

}  // namespace breccia
