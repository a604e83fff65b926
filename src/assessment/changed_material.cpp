#include "assessment/changed_material.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "viscoelasticity/two_moduli.hpp"
#include "viscoelasticity/youngs_modulus.hpp"

namespace breccia {
namespace {

using Number = MaterialNumber;

constexpr std::array elastic_constants = {Number::shear, Number::bulk, Number::young, Number::poisson};

/// The elastic constant that stays as it is where another is unknown alone.
Number partner_of(Number constant) {
  if (constant == Number::shear) return Number::bulk;
  if (constant == Number::bulk) return Number::shear;
  return constant == Number::young ? Number::poisson : Number::young;
}

double constant_of(const Material& material, Number constant) {
  const double of_bulk = material.bulk.equilibrium(), of_shear = material.shear.equilibrium();
  if (constant == Number::shear) return of_shear;
  if (constant == Number::bulk) return of_bulk;
  if (constant == Number::young) return youngs_modulus(of_bulk, of_shear);
  return (3.0 * of_bulk - 2.0 * of_shear) / (6.0 * of_bulk + 2.0 * of_shear);
}

[[noreturn]] void refuse(const Material& material, Number number, const std::string& reason) {
  throw InputError(fmt::format("{}.{}: {}", material.name, name_of(number), reason));
}

/// The elastic material with new elastic constants.
Material with_constants(Material material, std::map<Number, double> constants) {
  if (constants.size() > 2) {
    refuse(material, std::prev(constants.end())->first, "expected at most two elastic constants of a material");
  }
  if (constants.size() == 1) {
    const auto partner = partner_of(constants.begin()->first);
    constants[partner] = constant_of(material, partner);
  }
  TwoModuli given;
  for (const auto& [constant, value] : constants) {
    if (constant == Number::poisson) {
      given.poisson = value;
    } else {
      if (!(value > 0.0)) refuse(material, constant, fmt::format("expected a positive modulus, got {:.6g} Pa", value));
      auto& modulus = constant == Number::shear ? given.shear : constant == Number::bulk ? given.bulk : given.young;
      modulus = PronySeries(value);
    }
  }
  auto [of_bulk, of_shear] = bulk_and_shear(given);
  material.bulk = std::move(of_bulk);
  material.shear = std::move(of_shear);
  return material;
}

/// Gives a material that relaxes a new shear modulus.
void set_shear(Material& material, const PronySeries& series) {
  if (has_constant_poisson_ratio(material)) {
    material.bulk = series.scaled(material.bulk.unrelaxed() / material.shear.unrelaxed());
  }
  material.shear = series;
}

/// Throws InputError where a number is given beside another that would change it, or that changes the same.
void refuse_pairs(const Material& material, const MaterialChange& change) {
  const auto refuse_beside = [&](Number number, std::string_view other) {
    if (change.has(number))
      refuse(material, number, fmt::format("cannot be unknown beside the {} of the material", other));
  };
  if (change.shear_terms) {
    refuse_beside(Number::modulus, "spectrum");
    refuse_beside(Number::times, "spectrum");
  }
  if (change.has(Number::equilibrium)) refuse_beside(Number::modulus, "equilibrium");
  if (change.has(Number::young)) {
    refuse_beside(Number::shear, "Young's modulus");
    refuse_beside(Number::bulk, "Young's modulus");
  }
}

void change_law(ShiftedMaterial& material, const MaterialChange& change) {
  for (const auto number : {Number::c1, Number::c2}) {
    if (!change.has(number)) continue;
    auto* const law = material.shift ? std::get_if<WilliamsLandelFerry>(&material.shift->law) : nullptr;
    if (law == nullptr) {
      refuse(material.material, number, "the material has no shift law of Williams, Landel and Ferry");
    }
    (number == Number::c1 ? law->c1 : law->c2) = change.numbers.at(number);
  }
}

}  // namespace

bool has_constant_poisson_ratio(const Material& material) {
  constexpr double rounding = 1e-9;
  const auto& in_bulk = material.bulk.terms();
  const auto& in_shear = material.shear.terms();
  if (in_bulk.empty() || in_bulk.size() != in_shear.size()) return false;
  const double ratio = material.bulk.unrelaxed() / material.shear.unrelaxed();
  const auto is_multiple = [&](double of_bulk, double of_shear) {
    return std::abs(of_bulk - ratio * of_shear) <= rounding * material.bulk.unrelaxed();
  };
  return is_multiple(material.bulk.equilibrium(), material.shear.equilibrium()) &&
         std::ranges::equal(in_bulk, in_shear, [&](const MaxwellTerm& one, const MaxwellTerm& other) {
           return std::abs(one.relaxation_time - other.relaxation_time) <= rounding * other.relaxation_time &&
                  is_multiple(one.modulus, other.modulus);
         });
}

ShiftedMaterial changed(const ShiftedMaterial& given, const MaterialChange& change) {
  auto result = given;
  auto& material = result.material;
  refuse_pairs(material, change);
  std::map<Number, double> constants;
  for (const auto constant : elastic_constants) {
    if (!change.has(constant)) continue;
    if (!is_elastic(material)) {
      refuse(material, constant, "the material relaxes; expected its spectrum, equilibrium, modulus or times");
    }
    constants[constant] = change.numbers.at(constant);
  }
  if (!constants.empty()) material = with_constants(std::move(material), std::move(constants));
  const auto does_not_relax = std::string("the material does not relax; expected an elastic constant of it");
  for (const auto number : {Number::equilibrium, Number::modulus, Number::times}) {
    if (change.has(number) && is_elastic(given.material)) refuse(material, number, does_not_relax);
  }
  if (change.shear_terms) {
    if (is_elastic(given.material)) throw InputError(fmt::format("{}.spectrum: {}", material.name, does_not_relax));
    set_shear(material, {material.shear.equilibrium(), *change.shear_terms});
  }
  if (change.has(Number::equilibrium)) {
    set_shear(material, {change.numbers.at(Number::equilibrium), material.shear.terms()});
  }
  if (change.has(Number::modulus)) set_shear(material, material.shear.scaled(change.numbers.at(Number::modulus)));
  if (change.has(Number::times)) material = shifted(material, change.numbers.at(Number::times));
  change_law(result, change);
  return result;
}

}  // namespace breccia
