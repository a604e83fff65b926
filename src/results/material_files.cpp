#include "results/material_files.hpp"

#include <variant>

#include <fmt/format.h>

#include "deck/prony_file.hpp"
#include "io/safe_name.hpp"
#include "io/text_file.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

/// The beginning of the names of the files of a material: its name, with a hyphen in place of what a name of a file
/// should not have.
std::string stem_of(std::string material) {
  for (auto& letter : material) {
    if (!is_safe_name(std::string(1, letter)) && letter != '-' && letter != '_' && letter != '.') letter = '-';
  }
  return is_safe_name(material) ? material : "material" + material;
}

std::string file_of(const std::string& material, ModulusKind kind) {
  return fmt::format("{}-{}.csv", stem_of(material), kind == ModulusKind::shear ? "shear" : "bulk");
}

std::string file_of_shifts(const std::string& material) {
  return fmt::format("{}-shift_factors.csv", stem_of(material));
}

std::string quantity(double value, std::string_view unit) {
  return fmt::format("\"{} {}\"", value, unit);
}

/// Writes the files of one material.
class MaterialWriter {
 public:
  MaterialWriter(const std::filesystem::path& directory, const ShiftedMaterial& shifted)
      : directory_(directory), shifted_(shifted), name_(shifted.material.name), names_{stem_of(name_) + ".toml"} {}

  std::vector<std::string> write(const std::string& comment) {
    // A deck gives the moduli at the reference temperature of the shift law.
    const auto& [material, shift, constants, expansion] = shifted_;
    const auto reference = shift ? shifted(material, 1.0 / shift_factor(shift->law, shift->temperature)) : material;
    auto text = fmt::format("# {}\ndensity = {}\n", comment, quantity(material.density, "kg/m^3"));
    text += fmt::format("bulk    = {}\n", modulus(reference.bulk, ModulusKind::bulk));
    text += fmt::format("shear   = {}\n", modulus(reference.shear, ModulusKind::shear));
    if (expansion) text += fmt::format("thermal_expansion = {}\n", quantity(*expansion, "1/K"));
    if (shift) text += fmt::format("temperature_shift = {}\n", law(*shift));
    write_text(directory_ / names_.front(), text);
    return std::move(names_);
  }

 private:
  std::string modulus(const PronySeries& series, ModulusKind kind) {
    if (series.is_elastic()) return quantity(series.equilibrium(), "Pa");
    const auto file = file_of(name_, kind);
    write_prony_file(directory_ / file, series, kind, fmt::format("Modulus of {}.", name_));
    names_.push_back(file);
    return fmt::format("{{ prony = \"{}\" }}", file);
  }

  std::string law(const TemperatureShift& shift) {
    const auto temperature = quantity(shift.temperature, "K");
    if (const auto* const wlf = std::get_if<WilliamsLandelFerry>(&shift.law)) {
      return fmt::format(R"({{ law = "wlf", c1 = {}, c2 = {}, reference = {}, temperature = {} }})", wlf->c1,
                         quantity(wlf->c2, "K"), quantity(wlf->reference_temperature, "K"), temperature);
    }
    const auto& table = std::get<ShiftTable>(shift.law);
    const auto file = file_of_shifts(name_);
    write_csv(directory_ / file,
              {{"temperature_K", table.temperatures()}, {"log10_shift_factor", table.log10_factors()}});
    names_.push_back(file);
    return fmt::format(R"({{ law = "table", table = "{}", reference = {}, temperature = {} }})", file,
                       quantity(table.reference_temperature(), "K"), temperature);
  }

  const std::filesystem::path& directory_;
  const ShiftedMaterial& shifted_;
  const std::string& name_;
  std::vector<std::string> names_;
};

}  // namespace

std::vector<std::string> material_files(const std::string& material) {
  return {stem_of(material) + ".toml", file_of(material, ModulusKind::bulk), file_of(material, ModulusKind::shear),
          file_of_shifts(material)};
}

std::vector<std::string> write_material(const std::filesystem::path& directory, const ShiftedMaterial& material,
                                        const std::string& comment) {
  return MaterialWriter(directory, material).write(comment);
}

}  // namespace breccia
