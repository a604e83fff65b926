#include "fit_material.hpp"

#include <fmt/format.h>

namespace breccia::cli {
namespace {

/// A temperature [K] as a deck has it: "19 degC".
std::string in_celsius(double temperature) {
  constexpr double zero_celsius = 273.15;
  return fmt::format("{:.6g} degC", temperature - zero_celsius);
}

/// The key of a material for a modulus; one of unknown kind is taken for that of shear.
std::string_view key_of(ModulusKind kind) {
  if (kind == ModulusKind::young) return "young";
  return kind == ModulusKind::bulk ? "bulk" : "shear";
}

std::string shift_key(const FitResult& result, const std::string& directory) {
  const auto reference = in_celsius(result.master_curve->reference_temperature);
  const auto law =
      result.law ? fmt::format(R"(law = "wlf", c1 = {:.6g}, c2 = "{:.6g} K")", result.law->law.c1, result.law->law.c2)
                 : fmt::format(R"(law = "table", table = "{}shift_factors.csv")", directory);
  return fmt::format("temperature_shift = {{ {}, reference = \"{}\", temperature = \"{}\" }}\n", law, reference,
                     reference);
}

}  // namespace

std::string material_keys(const FitResult& result, const std::string& directory) {
  auto text = fmt::format("{} = {{ prony = \"{}prony.csv\" }}\n", key_of(result.kind), directory);
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
