#include "results/cards/comsol_card.hpp"

#include <fmt/format.h>

#include "results/cards/card_terms.hpp"

namespace breccia::cards {

std::string comsol_card(const MaterialCard& card) {
  auto text = comments_of(card, "%");
  text += fmt::format("% name: {}\n% density: {}\n", card.name, number(card.density));
  text += fmt::format("% long-term shear modulus G: {}\n% long-term bulk modulus K: {}\n",
                      number(card.shear.equilibrium()), number(card.bulk.equilibrium()));
  if (card.shift) {
    text += fmt::format("% shift function Williams-Landel-Ferry: T_ref {}, C1 {}, C2 {}\n",
                        number(card.shift->reference_temperature), number(card.shift->c1), number(card.shift->c2));
  }
  // COMSOL loads a table of branches for shear; branches for the volume must be entered by hand.
  int branch = 0;
  for (const auto& term : card.bulk.terms()) {
    text +=
        fmt::format("% volumetric branch {}: {} {}\n", ++branch, number(term.modulus), number(term.relaxation_time));
  }
  branch = 0;
  for (const auto& term : card.shear.terms()) {
    text += fmt::format("{} {} {}\n", ++branch, number(term.modulus), number(term.relaxation_time));
  }
  return text;
}

}  // namespace breccia::cards
