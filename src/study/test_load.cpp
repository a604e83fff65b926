#include "breccia/study/test_load.hpp"

#include <algorithm>

namespace breccia {

std::string name_of(TestLoad load) {
  return load.is_isotropic() ? name_of<TestLoad>(load) : name_of(*load.of_test());
}

std::span<const Load> isotropic_shears(int dimensions) {
  static constexpr std::array in_space = {Load::shear, Load::diagonal_shear, Load::shear_yz, Load::shear_zx,
                                          Load::axial_shear};
  static constexpr std::size_t in_plane = 2;
  return dimensions == 2 ? std::span(in_space).first(in_plane) : std::span<const Load>(in_space);
}

bool is_in_mean(TestLoad load, int dimensions) {
  const auto shears = isotropic_shears(dimensions);
  return std::ranges::find(shears, load) != shears.end();
}

bool has_test_load(TestLoad load, int dimensions) {
  return load.is_isotropic() || dimensions == 3 || has_load<2>(*load.of_test());
}

std::optional<TestLoad> main_shear(std::span<const TestLoad> loads) {
  for (const auto& load : {TestLoad::isotropic(), TestLoad(Load::shear)}) {
    if (std::ranges::find(loads, load) != loads.end()) return load;
  }
  const auto first = std::ranges::find_if_not(loads, &TestLoad::is_bulk);
  return first == loads.end() ? std::nullopt : std::optional(*first);
}

}  // namespace breccia
