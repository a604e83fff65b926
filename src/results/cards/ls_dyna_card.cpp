#include "results/cards/ls_dyna_card.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "results/cards/card_terms.hpp"

namespace breccia::cards {
namespace {

/// The shortest form of an exponent: 3.88e9 for 3.88e+09.
std::string with_short_exponent(const std::string& text) {
  const auto exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  return fmt::format("{}e{}", text.substr(0, exponent), std::stoi(text.substr(exponent + 1)));
}

/// A number in a field of ten columns, with as many digits as fit.
std::string field(double value) {
  constexpr int width = 10, most_digits = 9;
  for (int digits = most_digits; digits > 0; --digits) {
    const auto text = with_short_exponent(fmt::format("{:.{}g}", value, digits));
    if (text.size() < width) return fmt::format("{:>10}", text);
  }
  return fmt::format("{:>10.2e}", value);
}

}  // namespace

std::string ls_dyna_card(const MaterialCard& card) {
  auto text = comments_of(card, "$");
  text += fmt::format("*MAT_GENERAL_VISCOELASTIC_TITLE\n{}\n", card.name);
  text += "$#     mid        ro      bulk       pcf        ef      tref         a         b\n";
  text += fmt::format("{:>10}{}{}{:>10}{:>10}{:>10}{:>10}{:>10}\n", 1, field(card.density),
                      field(card.bulk.unrelaxed()), 0, 0, 0, 0, 0);
  text += "$#    lcid        nt    bstart     tramp     lcidk       ntk   bstartk    trampk\n\n";
  text += "$#      gi     betai        ki    betaki\n";
  // Without a bulk term the elastic bulk modulus above holds.
  const bool has_bulk_terms = !card.bulk.is_elastic();
  const auto row = [has_bulk_terms](double shear, double bulk, double decay) {
    auto line = field(shear) + field(decay);
    if (has_bulk_terms) line += field(bulk) + field(decay);
    return line + "\n";
  };
  for (const auto& term : terms_of(card)) text += row(term.shear, term.bulk, 1.0 / term.relaxation_time);
  return text + row(card.shear.equilibrium(), card.bulk.equilibrium(), 0.0);
}

}  // namespace breccia::cards
