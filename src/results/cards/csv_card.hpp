#pragma once

#include <string>

#include "results/material_card.hpp"

namespace breccia::cards {

/// The card as a table of terms with their moduli and shares, whose rows a deck can read (docs/exports.md). Its numbers
/// are written as they are, in the units of the card.
std::string csv_card(const MaterialCard& card);

}  // namespace breccia::cards
