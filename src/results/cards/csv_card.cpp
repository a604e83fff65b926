#include "results/cards/csv_card.hpp"

#include <fmt/format.h>

#include "results/cards/card_terms.hpp"

namespace breccia::cards {

std::string csv_card(const MaterialCard& card) {
  const double shear = card.shear.unrelaxed(), bulk = card.bulk.unrelaxed();
  auto text = comments_of(card, "#");
  text += fmt::format("# name: {}\n# density: {}\n", card.name, number(card.density));
  if (card.shift) {
    text += fmt::format("# Williams-Landel-Ferry: T_ref {} K, c1 {}, c2 {} K\n",
                        number(card.shift->reference_temperature), number(card.shift->c1), number(card.shift->c2));
  }
  text +=
      fmt::format("relaxation_time_s,shear_modulus_{0},bulk_modulus_{0},shear_share,bulk_share\n", card.pressure_unit);
  const auto row = [&](const std::string& time, double of_shear, double of_bulk) {
    return fmt::format("{},{},{},{},{}\n", time, number(of_shear), number(of_bulk), number(of_shear / shear),
                       number(of_bulk / bulk));
  };
  text += row("inf", card.shear.equilibrium(), card.bulk.equilibrium());
  for (const auto& term : terms_of(card)) text += row(number(term.relaxation_time), term.shear, term.bulk);
  return text;
}

}  // namespace breccia::cards
