#include "results/cards/ansys_card.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "results/cards/card_terms.hpp"
#include "viscoelasticity/poisson_ratio.hpp"
#include "viscoelasticity/youngs_modulus.hpp"

namespace breccia::cards {
namespace {

/// TB,PRONY with pairs of a share of the instantaneous modulus and a relaxation time, three a line.
std::string prony_table(std::string_view label, const PronySeries& series) {
  const auto& terms = series.terms();
  if (terms.empty()) return {};
  auto text = fmt::format("TB,PRONY,1,1,{},{}\n", terms.size(), label);
  constexpr std::size_t pairs_per_line = 3;
  for (std::size_t first = 0; first < terms.size(); first += pairs_per_line) {
    text += fmt::format("TBDATA,{}", 2 * first + 1);
    for (auto i = first; i < std::min(first + pairs_per_line, terms.size()); ++i) {
      text += fmt::format(",{},{}", number(terms[i].modulus / series.unrelaxed()), number(terms[i].relaxation_time));
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string ansys_card(const MaterialCard& card) {
  const double shear = card.shear.unrelaxed(), bulk = card.bulk.unrelaxed();
  auto text = comments_of(card, "!");
  text += fmt::format("MP,DENS,1,{}\nMP,EX,1,{}\nMP,NUXY,1,{}\n", number(card.density),
                      number(youngs_modulus(bulk, shear)), number(poisson_ratio(bulk, shear)));
  text += prony_table("SHEAR", card.shear) + prony_table("BULK", card.bulk);
  if (!card.shift) return text;
  return text + fmt::format("TB,SHIFT,1,1,3,WLF\nTBDATA,1,{},{},{}\n", number(card.shift->reference_temperature),
                            number(card.shift->c1), number(card.shift->c2));
}

}  // namespace breccia::cards
