#include "cli/fit_material.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cli/fit_law.hpp"
#include "io/units.hpp"

namespace breccia::cli {
namespace {

/// A temperature [K] as text for a deck: "19 degC", or with all digits "292.1515151515 K".
std::string as_quantity(double temperature) {
  constexpr double zero_celsius = 273.15, rounding = 1e-7;
  const auto celsius = fmt::format("{:.6g} degC", temperature - zero_celsius);
  const bool is_round = std::abs(parse_quantity(celsius, Dimension::temperature) - temperature) < rounding;
  return is_round ? celsius : fmt::format("{:.13g} K", temperature);
}

/// A text in the quotes of TOML.
std::string quoted(const std::string& text) {
  std::string escaped = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') escaped += '\\';
    escaped += letter;
  }
  return escaped + "\"";
}

/// The key of a material for a modulus. A modulus of unknown kind is taken as a shear modulus.
std::string_view key_of(ModulusKind kind) {
  if (kind == ModulusKind::young) return "young";
  return kind == ModulusKind::bulk ? "bulk" : "shear";
}

std::string shift_key(const FitResult& result, const std::string& directory) {
  const auto reference = as_quantity(result.master_curve->reference_temperature);
  const auto law = [&] {
    if (!follows_law(result))
      return fmt::format(R"(law = "table", table = {})", quoted(directory + "shift_factors.csv"));
    const auto& wlf = result.shift_law->law;
    return fmt::format(R"(law = "wlf", c1 = {:.6g}, c2 = "{:.6g} K")", wlf.c1, wlf.c2);
  }();
  return fmt::format("temperature_shift = {{ {}, reference = \"{}\", temperature = \"{}\" }}\n", law, reference,
                     reference);
}

}  // namespace

bool follows_law(const FitResult& result) {
  return result.shift_law && follow(*result.shift_law);
}

std::string material_keys(const FitResult& result, const std::string& directory) {
  const auto modulus =
      result.law ? law_for_deck(*result.law) : fmt::format("{{ prony = {} }}", quoted(directory + "prony.csv"));
  auto text = fmt::format("{} = {}\n", key_of(result.kind), modulus);
  if (result.master_curve) text += shift_key(result, directory);
  return text;
}

std::string material_file(const FitResult& result, const std::string& source) {
  auto text = fmt::format("# A material for a deck or `breccia respond --material`, fitted to {} by breccia {}.\n",
                          source, BRECCIA_VERSION);
  if (result.kind == ModulusKind::unspecified) {
    text += "# The data do not say which modulus was measured: `shear` stands for any; else write `young` or `bulk`.\n";
  }
  text += "# To be completed by what was not measured, the density and a second modulus, as in\n";
  text += "# density = \"1.2 g/cm^3\"\n";
  text += result.kind == ModulusKind::bulk ? "# shear   = \"1 GPa\"\n" : "# bulk    = \"3 GPa\"\n";
  return text + material_keys(result, "");
}

}  // namespace breccia::cli
