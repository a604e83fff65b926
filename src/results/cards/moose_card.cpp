#include "results/cards/moose_card.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/cards/card_terms.hpp"
#include "viscoelasticity/poisson_ratio.hpp"
#include "viscoelasticity/youngs_modulus.hpp"

namespace breccia::cards {
namespace {

/// All digits are written, since the first spring is the difference of the instantaneous stiffness and the branches. A
/// branch has both moduli above zero, since its stiffness is inverted: the bulk modulus of a branch that relaxes in
/// shear alone is this share of its shear modulus, and the reverse.
constexpr double least_share = 1e-5;

std::string list(const std::vector<std::string>& values) {
  return fmt::format("'{}'", fmt::join(values, " "));
}

}  // namespace

std::string moose_card(const MaterialCard& card) {
  std::vector<std::string> moduli, times, ratios;
  double shear_of_all = card.shear.equilibrium(), bulk_of_all = card.bulk.equilibrium();
  for (const auto& term : terms_of(card)) {
    const double shear = std::max(term.shear, least_share * term.bulk);
    const double bulk = std::max(term.bulk, least_share * term.shear);
    shear_of_all += shear;
    bulk_of_all += bulk;
    moduli.push_back(exact_number(youngs_modulus(bulk, shear)));
    ratios.push_back(exact_number(poisson_ratio(bulk, shear)));
    times.push_back(exact_number(term.relaxation_time));
  }
  auto text = comments_of(card, "#");
  text += fmt::format("[Materials]\n  [{}]\n", card.name);
  text += moduli.empty() ? "    type = ComputeIsotropicElasticityTensor\n    youngs_modulus = "
                         : "    type = GeneralizedMaxwellModel\n    young_modulus = ";
  text += fmt::format("{}\n    poisson_ratio = {}\n", exact_number(youngs_modulus(bulk_of_all, shear_of_all)),
                      exact_number(poisson_ratio(bulk_of_all, shear_of_all)));
  if (!moduli.empty()) {
    text += fmt::format("    creep_modulus = {}\n    creep_viscosity = {}\n    creep_ratio = {}\n", list(moduli),
                        list(times), list(ratios));
  }
  text +=
      fmt::format("  []\n  [{}-density]\n    type = GenericConstantMaterial\n    prop_names = density\n", card.name);
  text += fmt::format("    prop_values = {}\n  []\n  [{}-stress]\n", number(card.density), card.name);
  if (moduli.empty()) return text + "    type = ComputeLinearElasticStress\n  []\n[]\n";
  return text + fmt::format(
                    "    type = ComputeLinearViscoelasticStress\n  []\n[]\n[UserObjects]\n  [{0}-update]\n"
                    "    type = LinearViscoelasticityManager\n    viscoelastic_model = {0}\n  []\n[]\n",
                    card.name);
}

}  // namespace breccia::cards
