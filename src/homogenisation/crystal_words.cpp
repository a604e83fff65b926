#include "homogenisation/crystal_words.hpp"

#include <variant>

#include <fmt/format.h>

#include "breccia/discretisation/crystals.hpp"

#include "io/display.hpp"

namespace breccia {
namespace {

struct OrientationsInWords {
  const Stage& stage;

  std::string operator()(const RandomOrientations& random) const {
    return fmt::format("at random orientations (seed {})", random.seed.value_or(stage.seed().value_or(1)));
  }
  std::string operator()(const AlignedOrientations&) const {
    return "with the axes of the box, which make it anisotropic";
  }
  std::string operator()(const ListedOrientations& listed) const {
    return fmt::format("with the orientations of {}", listed.file.filename().string());
  }
};

std::string words_on(const Stage& stage, const Material& material, const Crystal& crystal) {
  const auto means = isotropic_means(stiffness_tensor(crystal.constants));
  const auto pressure = [](double value) { return display(value, "Pa", 3); };
  return fmt::format("crystals of {} {}; isotropic means by Hill: K {} (Reuss {}, Voigt {}), G {} ({}, {})",
                     material.name, std::visit(OrientationsInWords{stage}, crystal.orientations),
                     pressure(means.bulk()), pressure(means.bulk_reuss), pressure(means.bulk_voigt),
                     pressure(means.shear()), pressure(means.shear_reuss), pressure(means.shear_voigt));
}

}  // namespace

std::vector<std::string> words_on_crystals(const Stage& stage) {
  std::vector<std::string> sentences;
  for (const auto& filler : stage.fillers) {
    if (filler.crystal) sentences.push_back(words_on(stage, filler.material, *filler.crystal));
  }
  return sentences;
}

}  // namespace breccia
