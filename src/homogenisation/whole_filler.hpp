#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/filler_statistics.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The fraction of one material of fillers, or of coatings, in the composite.
struct FillerShare {
  std::string material;
  double fraction = 0.0;       ///< fraction by volume [-]
  double mass_fraction = 0.0;  ///< [-]
};

/// The filler of a stage together with the filler of the stages that it builds on.
struct WholeFiller {
  double fraction = 0.0;               ///< fraction by volume, without coatings and voids [-]
  double mass_fraction = 0.0;          ///< without coatings [-]
  double porosity = 0.0;               ///< fraction of the voids by volume [-]
  std::vector<FillerShare> materials;  ///< solid fillers, in the order in which the stages add them
  std::vector<FillerShare> coatings;   ///< coatings, in the same order
};

/// The filler of the composite that a stage of a study describes. `packed` are the statistics of the fillers of the
/// stages, in the order of the stages, at least up to this stage; throws InputError if there are fewer.
WholeFiller filler_of_the_whole(const Study& study, const Stage& stage,
                                const std::vector<std::vector<FillerStatistics>>& packed);

/// The filler in words: "filler of the whole: 80.1 % by volume, 88.0 % by mass (ap 71.0 %, al 17.0 %); voids: 2.0 % by
/// volume"; the shares in brackets are by mass. Empty without filler and voids.
std::string in_words(const WholeFiller& filler);

}  // namespace breccia
