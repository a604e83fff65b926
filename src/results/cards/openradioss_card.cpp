#include "results/cards/openradioss_card.hpp"

#include <string>

#include <fmt/format.h>

#include "results/cards/card_terms.hpp"
#include "viscoelasticity/poisson_ratio.hpp"

namespace breccia::cards {
namespace {

/// A number in a field of twenty columns.
std::string field(double value) {
  return fmt::format("{:>20}", number(value));
}

/// A whole number in a field of ten columns.
std::string count(std::size_t value) {
  return fmt::format("{:>10}", value);
}

}  // namespace

std::string openradioss_card(const MaterialCard& card) {
  const auto empty_column = std::string(10, ' ');
  const auto terms = terms_of(card);
  auto text = comments_of(card, "#");
  text += fmt::format("/MAT/LAW42/1\n{}\n", card.name);
  text += "#              RHO_I\n" + field(card.density) + "\n";
  text += "#                 Nu           sigma_cut          fct_IDblk          Fscale_blk         M    I_form\n";
  // Sixteen digits of a ratio near 0.5 keep the bulk modulus, which follows from 1 - 2 nu.
  text += fmt::format("{:>20.15f}", poisson_ratio(card.bulk.equilibrium(), card.shear.equilibrium())) + field(0.0) +
          empty_column + count(0) + field(0.0) + count(0) + count(0) + "\n";
  // The shear modulus of Ogden's solid is half of the sum of mu_i alpha_i.
  text += "#               mu_1                mu_2                mu_3                mu_4                mu_5\n";
  text += field(card.shear.equilibrium()) + field(0.0) + field(0.0) + field(0.0) + field(0.0) + "\n";
  text += "# blank\n\n";
  text += "#            alpha_1             alpha_2             alpha_3             alpha_4             alpha_5\n";
  text += field(2.0) + field(0.0) + field(0.0) + field(0.0) + field(0.0) + "\n";
  text += "# blank\n\n";
  if (terms.empty()) return text;
  text += "/VISC/PRONY/1\n";
  text += "#        M                           K_v      Itab    Ishape\n";
  text += count(terms.size()) + empty_column + field(0.0) + count(0) + count(0) + "\n";
  text += "#                G_i              Beta_i                 K_i             Betak_i\n";
  for (const auto& [time, shear, bulk] : terms) {
    text += field(shear) + field(1.0 / time) + field(bulk) + field(1.0 / time) + "\n";
  }
  return text;
}

}  // namespace breccia::cards
