#pragma once

#include <string>

#include "results/material_card.hpp"

namespace breccia::cards {

/// The card as lines of an Abaqus input file: instantaneous moduli and shares of them (docs/exports.md). Its numbers
/// are written as they are, in the units of the card.
std::string abaqus_card(const MaterialCard& card);

}  // namespace breccia::cards
