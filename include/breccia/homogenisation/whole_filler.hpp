#pragma once

#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// What a material of the filler makes up of the whole.
struct FillerShare {
  std::string material;
  double fraction = 0.0;       ///< by volume [-]
  double mass_fraction = 0.0;  ///< [-]
};

/// The filler of a stage together with that of the stages that it is built on.
struct WholeFiller {
  double fraction = 0.0;               ///< by volume [-]
  double mass_fraction = 0.0;          ///< [-]
  std::vector<FillerShare> materials;  ///< in the order in which the stages add them
};

/// The filler of the whole that a stage of a study stands for. `fractions` are those that the particles of each stage
/// fill of its box [-], in the order of the stages, at least up to this one; throws InputError where they are fewer.
WholeFiller filler_of_the_whole(const Study& study, const Stage& stage, const std::vector<double>& fractions);

/// "80.1 % by volume, 88.0 % by mass (ap 71.0 %, al 17.0 %)", the latter by mass.
std::string in_words(const WholeFiller& filler);

}  // namespace breccia
