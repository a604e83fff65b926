#pragma once

#include <string>

#include "results/material_card.hpp"

namespace breccia::cards {

/// The card as the table of branches that COMSOL loads, with their moduli in addition to the long-term moduli
/// (docs/exports.md). Its numbers are written as they are, in the units of the card.
std::string comsol_card(const MaterialCard& card);

}  // namespace breccia::cards
