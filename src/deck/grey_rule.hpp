#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "breccia/microstructure/grey_segmentation.hpp"
#include "breccia/rasters/raster.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// How the pixels of a grey picture become those of two phases.
struct GreyRule {
  std::optional<double> threshold = {};  ///< by Otsu's method if absent
  int median_side = 1;                   ///< as GreySegmentation::median_side
  Label dark = 0, bright = 0;            ///< numbers of the two phases
};

/// Reads `threshold` and `smooth`.
GreyRule read_grey_rule(const Section& packing);

/// A grey picture after its rule.
struct GreyLabels {
  GreySegmentation segmentation;
  std::vector<Label> labels;  ///< in the order of the raster
};

/// The labels of the pixels of a picture. Throws InputError where its values are no grey values, and where all pixels
/// are on one side of the threshold.
GreyLabels grey_labels(const Raster& raster, const GreyRule& rule);

}  // namespace breccia
