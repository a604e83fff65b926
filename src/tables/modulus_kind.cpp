#include "breccia/tables/modulus_kind.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace breccia {

std::string_view name(ModulusKind kind) {
  switch (kind) {
    case ModulusKind::shear:
      return "shear modulus";
    case ModulusKind::young:
      return "Young's modulus";
    case ModulusKind::bulk:
      return "bulk modulus";
    default:
      return "modulus";
  }
}

std::string_view column_prefix(ModulusKind kind) {
  switch (kind) {
    case ModulusKind::shear:
      return "shear_";
    case ModulusKind::young:
      return "youngs_";
    case ModulusKind::bulk:
      return "bulk_";
    default:
      return "";
  }
}

std::string_view symbol(ModulusKind kind) {
  if (kind == ModulusKind::young) return "E";
  return kind == ModulusKind::bulk ? "K" : "G";
}

std::optional<ModulusKind> kind_of_word(std::string_view word) {
  using enum ModulusKind;
  // "Elastic modulus" mostly means Young's modulus; the elastic modulus of rheology is called storage modulus.
  constexpr std::array<std::pair<std::string_view, ModulusKind>, 19> words{{
      {"shear", shear},        {"young", young},       {"youngs", young},      {"young's", young},
      {"tensile", young},      {"tension", young},     {"extensional", young}, {"uniaxial", young},
      {"flexural", young},     {"bending", young},     {"elastic", young},     {"bulk", bulk},
      {"volumetric", bulk},    {"compression", other}, {"compressive", other}, {"constrained", other},
      {"longitudinal", other}, {"oedometric", other},  {"plane", other},
  }};
  const auto* found = std::ranges::find(words, word, &std::pair<std::string_view, ModulusKind>::first);
  return found == words.end() ? std::nullopt : std::optional(found->second);
}

std::string conversion_hint(ModulusKind held, ModulusKind wanted) {
  const auto rename = fmt::format("begin the name of the column with {}", column_prefix(wanted));
  if (held == ModulusKind::young) {
    const auto* formula = wanted == ModulusKind::bulk ? "K = E / (3 (1 - 2 nu))" : "G = E / (2 (1 + nu))";
    return fmt::format("the key young takes it as it is, or convert it by {}, nu being Poisson's ratio, and {}",
                       formula, rename);
  }
  return fmt::format("it cannot be converted without another modulus; if it is the {} all the same, {}", name(wanted),
                     rename);
}

}  // namespace breccia
