#pragma once

#include <string>

#include "results/material_card.hpp"

namespace breccia::cards {

/// The card as blocks of a MOOSE input file: instantaneous moduli and branches (docs/exports.md). Its numbers are
/// written as they are, in the units of the card.
std::string moose_card(const MaterialCard& card);

}  // namespace breccia::cards
