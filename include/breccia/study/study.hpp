#pragma once

#include <string>
#include <vector>

#include "breccia/deckfile/uncertain_input.hpp"
#include "breccia/study/measurement.hpp"
#include "breccia/study/provenance.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/tests.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

/// A computation as it is requested, in SI units: microstructures on several scales, which may serve as matrices of
/// later ones, and the virtual tests of all of them. read_study() reads a study from a deck.
struct Study {
  std::string title = {};
  std::vector<ShiftedMaterial> materials = {};  ///< the named materials, in the order of the deck
  std::vector<Stage> stages;  ///< stages from the smallest scale up; an earlier stage may be the matrix of a later one
  Tests tests;
  std::vector<Measurement> measurements = {};
  /// The inputs that are not certain: the study has their medians, or the first of their choices.
  std::vector<UncertainInput> uncertain = {};
  Provenance provenance = {};
};

}  // namespace breccia
