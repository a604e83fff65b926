#include "homogenisation/box/debonded_films.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

template <int dim>
CellFaces<dim> debonded_films(const Stage& stage, const Tessellation<dim>& tessellation) {
  if (!stage.bonds) return {};
  const auto& bonds = *stage.bonds;
  try {
    if (!bonds.films.empty()) return faces_of_pairs(tessellation, bonds.films);
    if (bonds.normal.empty()) {
      return random_faces(tessellation, bonds.debonded, bonds.seed.value_or(stage.seed().value_or(1)));
    }
    Vector<dim> normal{};
    std::ranges::copy(bonds.normal, normal.begin());
    return faces_across(tessellation, bonds.debonded, normal);
  } catch (const InputError& error) {
    throw InputError(fmt::format("stage {}: bonds: {}", stage.name, error.what()));
  }
}

template CellFaces<2> debonded_films(const Stage&, const Tessellation<2>&);
template CellFaces<3> debonded_films(const Stage&, const Tessellation<3>&);

}  // namespace breccia
