#pragma once

#include <string>

#include "results/material_card.hpp"

namespace breccia::cards {

/// The card as the OpenRadioss keywords /MAT/LAW42, a neo-Hookean solid of the moduli at infinite time, and
/// /VISC/PRONY, the terms as moduli and decay constants (docs/exports.md). Its numbers are written as they are, in the
/// units of the card. Poisson's ratio at infinite time must be above 0.
std::string openradioss_card(const MaterialCard& card);

}  // namespace breccia::cards
