#include "results/cards/abaqus_card.hpp"

#include <fmt/format.h>

#include "results/cards/card_terms.hpp"
#include "viscoelasticity/poisson_ratio.hpp"
#include "viscoelasticity/youngs_modulus.hpp"

namespace breccia::cards {

std::string abaqus_card(const MaterialCard& card) {
  const double shear = card.shear.unrelaxed(), bulk = card.bulk.unrelaxed();
  auto text = comments_of(card, "**");
  text += fmt::format("*Material, name={}\n*Density\n{},\n*Elastic, moduli=INSTANTANEOUS\n{}, {}\n", card.name,
                      number(card.density), number(youngs_modulus(bulk, shear)), number(poisson_ratio(bulk, shear)));
  const auto terms = terms_of(card);
  if (terms.empty()) return text;
  text += "*Viscoelastic, time=PRONY\n";
  for (const auto& term : terms) {
    text +=
        fmt::format("{}, {}, {}\n", number(term.shear / shear), number(term.bulk / bulk), number(term.relaxation_time));
  }
  if (!card.shift) return text;
  return text + fmt::format("*Trs, definition=WLF\n{}, {}, {}\n", number(card.shift->reference_temperature),
                            number(card.shift->c1), number(card.shift->c2));
}

}  // namespace breccia::cards
