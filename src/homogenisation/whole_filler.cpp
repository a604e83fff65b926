#include "homogenisation/whole_filler.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "homogenisation/inclusions.hpp"
#include "study/chain.hpp"

namespace breccia {
namespace {

/// The fillers and coatings of a stage and of the stages that it builds on, each material once. Adding the particles of
/// a stage reduces the fractions of all others by the same factor.
std::vector<Inclusion> parts_of(const Study& study, const Stage& stage,
                                const std::vector<std::vector<FillerStatistics>>& packed) {
  const auto* const below = stage_of_matrix(study, stage);
  auto parts = below == nullptr ? std::vector<Inclusion>() : parts_of(study, *below, packed);
  if (stage.fillers.empty()) return parts;
  const auto number = static_cast<std::size_t>(
      std::distance(study.stages.begin(), std::ranges::find(study.stages, stage.name, &Stage::name)));
  if (number >= packed.size()) throw InputError("filler of the whole: expected the fillers of every stage");
  const auto own = inclusions_of(stage, packed[number]);
  for (auto& part : parts) part.fraction *= 1.0 - fraction_of(own);
  for (const auto& added : own) {
    const auto known = std::ranges::find_if(parts, [&](const Inclusion& part) {
      return part.material->name == added.material->name && part.is_coating == added.is_coating;
    });
    if (known == parts.end()) {
      parts.push_back(added);
    } else {
      known->fraction += added.fraction;
    }
  }
  return parts;
}

}  // namespace

WholeFiller filler_of_the_whole(const Study& study, const Stage& stage,
                                const std::vector<std::vector<FillerStatistics>>& packed) {
  const auto parts = parts_of(study, stage, packed);
  const double density = density_with(parts, binder_of(study, stage).density);
  WholeFiller whole;
  double mass = 0.0;  // mass of the filler per volume of the composite [kg/m^3]
  for (const auto& [material, fraction, is_coating] : parts) {
    if (is_void(*material)) {
      whole.porosity += fraction;
      continue;
    }
    auto& shares = is_coating ? whole.coatings : whole.materials;
    shares.push_back({material->name, fraction, fraction * material->density / density});
    if (is_coating) continue;
    whole.fraction += fraction;
    mass += fraction * material->density;
  }
  whole.mass_fraction = mass / density;
  return whole;
}

std::string in_words(const WholeFiller& filler) {
  auto voids =
      filler.porosity > 0.0 ? fmt::format("voids: {:.1f} % by volume", 100.0 * filler.porosity) : std::string();
  if (!(filler.fraction > 0.0)) return voids;
  auto text = fmt::format("filler of the whole: {:.1f} % by volume, {:.1f} % by mass", 100.0 * filler.fraction,
                          100.0 * filler.mass_fraction);
  const auto listed = [](const std::vector<FillerShare>& shares) {
    std::vector<std::string> words;
    words.reserve(shares.size());
    for (const auto& share : shares) {
      words.push_back(fmt::format("{} {:.1f} %", share.material, 100.0 * share.mass_fraction));
    }
    return fmt::format("{}", fmt::join(words, ", "));
  };
  if (filler.materials.size() > 1) text += fmt::format(" ({})", listed(filler.materials));
  if (!filler.coatings.empty()) text += fmt::format("; coatings by mass: {}", listed(filler.coatings));
  if (!voids.empty()) text += "; " + voids;
  return text;
}

}  // namespace breccia
