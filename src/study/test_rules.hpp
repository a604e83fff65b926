#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

// Rules for the tests of a study that the deck reader and require_sound share. Those that return texts return what is
// wrong, one line for each mistake, without saying where.

/// Does an element stand in a list twice?
template <class T>
bool has_repeats(const std::vector<T>& values) {
  for (auto value = values.begin(); value != values.end(); ++value) {
    if (std::find(values.begin(), value, *value) != value) return true;
  }
  return false;
}

/// Each number of a list must be larger than the one before.
bool is_rising(const std::vector<double>& values);

/// The times of fields must rise, and lie within the times of the tests.
std::vector<std::string> mistakes_of_field_times(const std::vector<double>& field_times, const TimeWindow& times);

/// The loads that a box of so many dimensions does not have, each with those that it has.
std::vector<std::string> mistakes_of_loads(const std::vector<Load>& loads, int dimensions);

/// What the stage is computed with: films where the tests ask for them and it has grains, cells otherwise.
Model model_of(const Tests& tests, const Stage& stage);

/// Whether tests of the stage save fields: those of cells and of thin films do, at the times that the tests have for
/// them.
bool has_fields(const Tests& tests, const Stage& stage);

/// What each part of a study allows and the whole does not: mixed cells with standard volumetric strains, films along
/// the walls under a boundary other than displacement, what the model of films does not have, and too few times for the
/// fits that the study needs.
std::vector<std::string> contradictions(const Study& study);

}  // namespace breccia
