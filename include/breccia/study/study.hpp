#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/study/measurement.hpp"
#include "breccia/study/provenance.hpp"
#include "breccia/study/stage.hpp"
#include "breccia/study/tests.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/temperature_shift.hpp"

namespace breccia {

/// What is asked for, in SI units: microstructures on several scales, each the matrix of the next or of none, and the
/// virtual tests that all of them undergo. A deck is a study written down (read_study).
struct Study {
  std::string title = {};
  std::vector<Material> materials = {};  ///< all that have a name, in the order of the deck
  /// By the names of the materials that have one; their relaxation times are shifted already.
  std::map<std::string, TemperatureShift> temperature_shifts = {};
  std::vector<Stage> stages;  ///< from the smallest scale up: a stage may have an earlier one as its matrix
  Tests tests;
  std::vector<Measurement> measurements = {};
  Provenance provenance = {};
};

}  // namespace breccia
