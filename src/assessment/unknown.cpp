#include "breccia/assessment/unknown.hpp"

#include <fmt/format.h>

namespace breccia {
namespace {

struct NameOf {
  std::string operator()(const UnknownNumber& unknown) const {
    return fmt::format("{}.{}", unknown.material, name_of(unknown.number));
  }
  std::string operator()(const UnknownSpectrum& unknown) const { return fmt::format("{}.spectrum", unknown.material); }
};

struct PriorOf {
  Distribution operator()(const UnknownNumber& unknown) const { return unknown.prior; }
  Distribution operator()(const UnknownSpectrum& unknown) const { return unknown.term; }
};

struct UnitOf {
  std::string_view operator()(const UnknownNumber& unknown) const { return unit_of(unknown.number); }
  std::string_view operator()(const UnknownSpectrum& /*unknown*/) const { return "Pa"; }
};

}  // namespace

std::string_view unit_of(MaterialNumber number) {
  switch (number) {
    case MaterialNumber::shear:
    case MaterialNumber::bulk:
    case MaterialNumber::young:
    case MaterialNumber::equilibrium:
      return "Pa";
    case MaterialNumber::c2:
      return "K";
    case MaterialNumber::poisson:
    case MaterialNumber::modulus:
    case MaterialNumber::times:
    case MaterialNumber::c1:
      break;
  }
  return "";
}

std::string_view unit_of(const Unknown& unknown) {
  return std::visit(UnitOf{}, unknown);
}

const std::string& material_of(const Unknown& unknown) {
  return std::visit([](const auto& one) -> const std::string& { return one.material; }, unknown);
}

Distribution prior_of(const Unknown& unknown) {
  return std::visit(PriorOf{}, unknown);
}

std::string name_of(const Unknown& unknown) {
  return std::visit(NameOf{}, unknown);
}

}  // namespace breccia
