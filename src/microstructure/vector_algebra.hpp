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
inline std::array<double, dim>& operator+=(std::array<double, dim>& a, const std::array<double, dim>& b) noexcept {
  for (std::size_t d = 0; d < dim; ++d) a[d] += b[d];
  return a;
}

template <std::size_t dim>
inline std::array<double, dim>& operator-=(std::array<double, dim>& a, const std::array<double, dim>& b) noexcept {
  for (std::size_t d = 0; d < dim; ++d) a[d] -= b[d];
  return a;
}

template <std::size_t dim>
[[nodiscard]] inline std::array<double, dim> operator+(std::array<double, dim> a,
                                                       const std::array<double, dim>& b) noexcept {
  return a += b;
}

template <std::size_t dim>
[[nodiscard]] inline std::array<double, dim> operator-(std::array<double, dim> a,
                                                       const std::array<double, dim>& b) noexcept {
  return a -= b;
}

template <std::size_t dim>
[[nodiscard]] inline std::array<double, dim> operator*(double factor, std::array<double, dim> a) noexcept {
  for (double& x : a) x *= factor;
  return a;
}

template <std::size_t dim>
[[nodiscard]] inline std::array<double, dim> operator/(std::array<double, dim> a, double divisor) noexcept {
  for (double& x : a) x /= divisor;
  return a;
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
