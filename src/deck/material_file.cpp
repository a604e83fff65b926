#include "breccia/deck/material_file.hpp"

#include "breccia/io/deck.hpp"

#include "materials.hpp"

namespace breccia {

Material read_material_file(const std::filesystem::path& file) {
  const Deck document(file);
  auto material = read_material(document.root(), file.stem().string());
  document.finish();
  return material;
}

}  // namespace breccia
