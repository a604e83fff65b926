#include "viscoelasticity/two_moduli.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"

namespace breccia {
namespace {

/// The shear modulus of a solid of an elastic bulk modulus: its compliance is 3 D(t) - 1 / (3 K), where D(t) is the
/// tensile compliance.
PronySeries shear_of_young(const PronySeries& young, double bulk) {
  if (!(young.unrelaxed() < 9.0 * bulk)) {
    throw InputError(fmt::format("expected Young's modulus below nine times the bulk modulus, got {:.4g} and {:.4g} Pa",
                                 young.unrelaxed(), bulk));
  }
  if (young.is_elastic()) {
    const double modulus = young.equilibrium();
    return PronySeries(3.0 * bulk * modulus / (9.0 * bulk - modulus));
  }
  const auto tensile = creep_compliance(young);
  std::vector<RetardationTerm> terms;
  for (const auto& [time, compliance] : tensile.terms()) terms.push_back({time, 3.0 * compliance});
  return relaxation_modulus(
      {3.0 * tensile.instantaneous() - 1.0 / (3.0 * bulk), std::move(terms), 3.0 * tensile.fluidity()});
}

}  // namespace

BulkAndShear bulk_and_shear(const TwoModuli& given) {
  const auto& [bulk, shear, young, poisson] = given;
  if (bulk && shear) return {*bulk, *shear};
  if (poisson) {
    const double over_shear = 2.0 * (1.0 + *poisson), over_bulk = 3.0 * (1.0 - 2.0 * *poisson);
    if (young) return {young->scaled(1.0 / over_bulk), young->scaled(1.0 / over_shear)};
    if (shear) return {shear->scaled(over_shear / over_bulk), *shear};
    return {*bulk, bulk->scaled(over_bulk / over_shear)};
  }
  if (bulk && young) {
    if (!bulk->is_elastic()) {
      throw InputError("with Young's modulus the bulk modulus is elastic; of one that relaxes give the shear modulus");
    }
    return {*bulk, shear_of_young(*young, bulk->equilibrium())};
  }
  if (!young || !shear) throw InputError("expected two of bulk, shear, Young's modulus and Poisson's ratio");
  if (!young->is_elastic() || !shear->is_elastic()) {
    throw InputError(
        "Young's modulus and the shear modulus of a solid that relaxes do not determine its bulk modulus well: give "
        "the "
        "bulk modulus or Poisson's ratio with one of them");
  }
  const double modulus = young->equilibrium(), of_shear = shear->equilibrium();
  if (!(modulus < 3.0 * of_shear)) {
    throw InputError(fmt::format(
        "expected Young's modulus below three times the shear modulus, got {:.4g} and {:.4g} Pa", modulus, of_shear));
  }
  return {PronySeries(modulus * of_shear / (3.0 * (3.0 * of_shear - modulus))), *shear};
}

}  // namespace breccia
