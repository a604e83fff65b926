#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "breccia/discretisation/load.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The load to which a curve belongs: one load of a virtual test, or all shears of a box, whose mean modulus is the
/// shear modulus of the isotropic part of the stiffness (theory, Eq. 13a).
class TestLoad {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): a load of a virtual test is one of the loads of curves
  constexpr TestLoad(Load load) noexcept : load_(load) {}
  static constexpr TestLoad isotropic() noexcept { return {}; }

  [[nodiscard]] constexpr bool is_isotropic() const noexcept { return !load_; }
  [[nodiscard]] constexpr bool is_bulk() const noexcept { return load_ == Load::bulk; }
  /// The load of the virtual test; nothing for the mean of several.
  [[nodiscard]] constexpr std::optional<Load> of_test() const noexcept { return load_; }

  friend constexpr bool operator==(const TestLoad&, const TestLoad&) noexcept = default;

 private:
  constexpr TestLoad() noexcept = default;

  std::optional<Load> load_ = {};
};

namespace detail {

template <std::size_t... index>
constexpr std::array<Word<TestLoad>, sizeof...(index) + 1> words_of_test_loads(
    std::index_sequence<index...> /*loads*/) {
  return {{{"isotropic", TestLoad::isotropic()}, {words<Load>[index].first, words<Load>[index].second}...}};
}

}  // namespace detail

template <>
inline constexpr auto words<TestLoad> = detail::words_of_test_loads(std::make_index_sequence<words<Load>.size()>());

/// The name of a load, also of a pair of loads.
[[nodiscard]] std::string name_of(TestLoad load);

/// The shears of a box of so many dimensions whose mean modulus is isotropic: two in the plane, five in space, each
/// orthogonal to the others.
std::span<const Load> isotropic_shears(int dimensions);

/// Whether the isotropic mean of a box of so many dimensions takes the shear of a load.
bool is_in_mean(TestLoad load, int dimensions);

/// Whether a box of so many dimensions has a load.
bool has_test_load(TestLoad load, int dimensions);

/// The load whose modulus is shown as G where there are several: the isotropic mean, else shear, else the first shear;
/// nothing without a shear.
std::optional<TestLoad> main_shear(std::span<const TestLoad> loads);

}  // namespace breccia
