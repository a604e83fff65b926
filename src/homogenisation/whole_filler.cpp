#include "breccia/homogenisation/whole_filler.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/study/chain.hpp"

namespace breccia {
namespace {

/// A material and its volume fraction in the composite [-].
struct Part {
  const Material* material;
  double fraction;
};

/// The filler of a stage and of the stages that it builds on. Adding the particles of a stage reduces the fractions of
/// all others by the same factor.
std::vector<Part> parts_of(const Study& study, const Stage& stage, const std::vector<double>& fractions) {
  const auto* const below = stage_of_matrix(study, stage);
  auto parts = below == nullptr ? std::vector<Part>() : parts_of(study, *below, fractions);
  if (!stage.filler) return parts;
  const auto number = static_cast<std::size_t>(
      std::distance(study.stages.begin(), std::ranges::find(study.stages, stage.name, &Stage::name)));
  if (number >= fractions.size()) throw InputError("filler of the whole: expected the fraction of every stage");
  for (auto& part : parts) part.fraction *= 1.0 - fractions[number];
  const auto& name = stage.filler->material.name;
  const auto known = std::ranges::find_if(parts, [&](const Part& part) { return part.material->name == name; });
  if (known == parts.end()) {
    parts.push_back({&stage.filler->material, fractions[number]});
  } else {
    known->fraction += fractions[number];
  }
  return parts;
}

}  // namespace

WholeFiller filler_of_the_whole(const Study& study, const Stage& stage, const std::vector<double>& fractions) {
  const auto parts = parts_of(study, stage, fractions);
  WholeFiller whole;
  double mass = 0.0;  // mass of the filler per volume of the composite [kg/m^3]
  for (const auto& [material, fraction] : parts) {
    whole.fraction += fraction;
    mass += fraction * material->density;
  }
  const double density = mass + (1.0 - whole.fraction) * binder_of(study, stage).density;
  whole.mass_fraction = mass / density;
  for (const auto& [material, fraction] : parts) {
    whole.materials.push_back({material->name, fraction, fraction * material->density / density});
  }
  return whole;
}

std::string in_words(const WholeFiller& filler) {
  auto text =
      fmt::format("{:.1f} % by volume, {:.1f} % by mass", 100.0 * filler.fraction, 100.0 * filler.mass_fraction);
  if (filler.materials.size() < 2) return text;
  std::vector<std::string> shares;
  for (const auto& share : filler.materials) {
    shares.push_back(fmt::format("{} {:.1f} %", share.material, 100.0 * share.mass_fraction));
  }
  return text + fmt::format(" ({})", fmt::join(shares, ", "));
}

}  // namespace breccia
