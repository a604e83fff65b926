#pragma once

#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// The fraction of one filler material in the composite.
struct FillerShare {
  std::string material;
  double fraction = 0.0;       ///< by volume [-]
  double mass_fraction = 0.0;  ///< [-]
};

/// The filler of a stage together with the filler of the stages that it builds on.
struct WholeFiller {
  double fraction = 0.0;               ///< by volume [-]
  double mass_fraction = 0.0;          ///< [-]
  std::vector<FillerShare> materials;  ///< in the order in which the stages add them
};

/// The filler of the composite that a stage of a study describes. `fractions` are the volume fractions of the particles
/// in the boxes of the stages [-], in the order of the stages, at least up to this one; throws InputError if there are
/// fewer.
WholeFiller filler_of_the_whole(const Study& study, const Stage& stage, const std::vector<double>& fractions);

/// The filler in words: "80.1 % by volume, 88.0 % by mass (ap 71.0 %, al 17.0 %)"; the shares in brackets are by mass.
std::string in_words(const WholeFiller& filler);

}  // namespace breccia
