#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/material_card.hpp"

namespace breccia::cards {

/// The terms of both moduli that have the same relaxation time.
struct CardTerm {
  double relaxation_time;  ///< relaxation time [s]
  double shear;            ///< term of G(t) in the unit of the card; 0 where there is none
  double bulk;             ///< term of K(t) in the unit of the card; 0 where there is none
};

/// The terms of both moduli, from the fastest to the slowest.
std::vector<CardTerm> terms_of(const MaterialCard& card);

/// The lines about the origin of the card, each behind the sign of a comment.
std::string comments_of(const MaterialCard& card, std::string_view sign);

/// A number with twelve digits, and with a decimal point or an exponent.
std::string number(double value);

/// A number with so many digits that it is read back as the same double.
std::string exact_number(double value);

}  // namespace breccia::cards
