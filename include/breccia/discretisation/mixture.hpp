#pragma once

#include <array>
#include <span>
#include <vector>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/discretisation/phase.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The treatment of a cell that an interface crosses.
enum class Mixing {
  series,  ///< the series mixture of its phases, by area fraction (theory, Eq. 40)
  points   ///< each of its material points has the phase at its position, as in the paper
};

template <>
inline constexpr auto words<Mixing> = std::to_array<Word<Mixing>>({{"series", Mixing::series},
                                                                   {"points", Mixing::points}});

/// A phase in a mixed cell, with its share of the cell.
struct MixedPart {
  PhaseIndex phase;
  double fraction;  ///< share of the area or volume of the cell [-]

  friend bool operator==(const MixedPart&, const MixedPart&) = default;
};

/// The content of a mixed cell: at least two phases, whose fractions add up to 1.
using Mixture = std::vector<MixedPart>;

/// Moduli of a mixture in series: its shear modulus and its dilatational modulus are the harmonic means of those of its
/// phases, 1 / G = sum of f_k / G_k (theory, Eq. 40). If a modulus of one phase is 0, that of the mixture is 0.
template <int dim>
[[nodiscard]] Moduli series_moduli(const Mixture& mixture, std::span<const Moduli> by_phase);

/// The mixture as a material. Its compliances are the means of the compliances of its phases, converted to moduli
/// exactly, and its density is the mean density. In plane strain its bulk modulus K, the difference of the dilatational
/// modulus K + G/3 and of G/3, may have negative terms. Throws InputError where a dilatational or a shear modulus of a
/// phase has negative terms. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] Material series_material(const Mixture& mixture, std::span<const Material> by_phase);

}  // namespace breccia
