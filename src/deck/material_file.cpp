#include "breccia/deck/material_file.hpp"

#include <system_error>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/io/deck.hpp"

#include "materials.hpp"

namespace breccia {

Material read_material_file(const std::filesystem::path& file) {
  std::error_code is_no_name_of_a_file;  // too long, for example
  if (!std::filesystem::exists(file, is_no_name_of_a_file)) {
    throw InputError(fmt::format("{}: no such file", file.string()));
  }
  const Deck document(file);
  auto material = read_material(document.root(), file.stem().string());
  document.finish();
  return material;
}

}  // namespace breccia
