#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace breccia {

template <std::size_t dim>
[[nodiscard]] inline double dot(const std::array<double, dim>& a, const std::array<double, dim>& b) noexcept {
  double sum = 0.0;
  for (std::size_t d = 0; d < dim; ++d) sum += a[d] * b[d];
  return sum;
}

template <std::size_t dim>
[[nodiscard]] inline std::array<double, dim> difference(const std::array<double, dim>& a,
                                                        const std::array<double, dim>& b) noexcept {
  std::array<double, dim> result = a;
  for (std::size_t d = 0; d < dim; ++d) result[d] -= b[d];
  return result;
}

/// a + factor * b
template <std::size_t dim>
[[nodiscard]] inline std::array<double, dim> displaced(const std::array<double, dim>& a, double factor,
                                                       const std::array<double, dim>& b) noexcept {
  std::array<double, dim> result = a;
  for (std::size_t d = 0; d < dim; ++d) result[d] += factor * b[d];
  return result;
}

template <std::size_t dim>
[[nodiscard]] inline double norm(const std::array<double, dim>& a) noexcept {
  return std::sqrt(dot(a, a));
}

/// The component of a x b out of the plane: positive if b lies counter-clockwise of a.
[[nodiscard]] inline double cross(const std::array<double, 2>& a, const std::array<double, 2>& b) noexcept {
  return a[0] * b[1] - a[1] * b[0];
}

}  // namespace breccia
