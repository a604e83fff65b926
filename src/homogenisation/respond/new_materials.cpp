#include "breccia/homogenisation/new_materials.hpp"

#include <utility>

#include <fmt/format.h>

namespace breccia {

NewMaterial new_material(std::string name, ShiftedMaterial given) {
  if (given.constants) {
    throw InputError(
        fmt::format("{}: {} is a crystal; expected an isotropic material, which alone can replace another one", name,
                    given.material.name));
  }
  return {std::move(name), std::move(given.material), std::move(given.shift)};
}

}  // namespace breccia
