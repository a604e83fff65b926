#pragma once

#include <string>

#include "results/material_card.hpp"

namespace breccia::cards {

/// The card as the LS-DYNA keyword *MAT_GENERAL_VISCOELASTIC (076): moduli and decay constants (docs/exports.md). Its
/// numbers are written as they are, in the units of the card.
std::string ls_dyna_card(const MaterialCard& card);

}  // namespace breccia::cards
