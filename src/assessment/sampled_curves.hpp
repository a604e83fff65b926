#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/homogenisation/responder.hpp"
#include "breccia/homogenisation/study_result.hpp"

namespace breccia {

/// A stage of a study with uncertain inputs: what was solved, and the samples that its responses answer.
struct SampledStage {
  const StageFindings& reference;                        ///< the stage with the median of each input
  std::vector<Responder> boxes;                          ///< the responders of the boxes
  std::vector<std::size_t> box_of = {};                  ///< index of the box of each sample
  std::vector<std::vector<NewMaterial>> materials = {};  ///< the materials of each sample that differ from the box's
  int threads = 0;                                       ///< number of threads; 0: all cores
};

/// The curves of a stage in all samples: G and, where it was tested, the modulus of the bulk test; over frequency |G*|
/// and the phase. Of several boundaries the periodic one is taken, or else the first. Throws InputError where the stage
/// has no shear, NotCovered where a sample is outside of what a box has sampled.
std::vector<SampledCurve> sample_curves(const SampledStage& stage);

}  // namespace breccia
