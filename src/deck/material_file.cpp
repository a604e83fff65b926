#include "deck/material_file.hpp"

#include <system_error>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deck/materials.hpp"
#include "deckfile/deck.hpp"

namespace breccia {
namespace {

ShiftedMaterial material_of(const Deck& document, const std::string& name) {
  if (document.root().has("materials")) {
    document.root().report("materials",
                           "expected the keys of one material, density, shear and so on, as a deck has them below "
                           "[materials.NAME], without this line");
    document.finish();
  }
  auto material = read_shifted_material(document.root(), name);
  for (const auto& input : document.uncertain_inputs()) {
    document.root().report("", fmt::format("{}: expected one value; distributions are for decks", input.name));
  }
  document.finish();
  return material;
}

}  // namespace

ShiftedMaterial read_shifted_material_file(const std::filesystem::path& file) {
  std::error_code is_no_name_of_a_file;  // too long, for example
  if (!std::filesystem::exists(file, is_no_name_of_a_file)) {
    throw InputError(fmt::format("{}: no such file", file.string()));
  }
  return material_of(Deck(file), file.stem().string());
}

ShiftedMaterial shifted_material_from_text(const std::string& text, const std::string& name,
                                           const std::filesystem::path& directory) {
  return material_of(Deck::from_text(text, name, directory), name);
}

}  // namespace breccia
