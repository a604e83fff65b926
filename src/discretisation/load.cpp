#include "breccia/discretisation/load.hpp"

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

std::string name_of(Load load) {
  if (const auto pair = pair_of(load)) return fmt::format("{} + {}", name_of(pair->one), name_of(pair->other));
  return name_of<Load>(load);
}

void require_loads(std::string_view calculation, int dimensions, std::span<const Load> loads) {
  for (const auto load : loads) {
    if (dimensions > 2 || has_load<2>(load)) continue;
    throw InputError(fmt::format("{}: the load \"{}\" is one of three dimensions, and the composite has two",
                                 calculation, name_of(load)));
  }
}

}  // namespace breccia
