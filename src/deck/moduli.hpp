#pragma once

#include <optional>

#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// The moduli of a material in a deck [Pa].
struct DeckModuli {
  PronySeries bulk = {};
  PronySeries shear = {};
  /// Law of a modulus measured at several temperatures; nothing if two moduli have one.
  std::optional<ShiftLaw> shift_law = {};
};

/// Reads the two of `bulk`, `shear`, `young` and `poisson` that a material has, and finds its bulk and its shear
/// modulus. After a mistake, which is reported, the moduli are empty.
DeckModuli read_moduli(const Section& material);

}  // namespace breccia
