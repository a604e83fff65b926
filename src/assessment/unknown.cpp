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

}  // namespace

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
