#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

// Rules for the tests of a study that the deck reader and require_sound share. Functions that return texts return the
// mistakes, a line each, without their locations.

/// Whether a list has an element twice.
template <class T>
bool has_repeats(const std::vector<T>& values) {
  for (auto value = values.begin(); value != values.end(); ++value) {
    if (std::find(values.begin(), value, *value) != value) return true;
  }
  return false;
}

/// Whether each number of a list is larger than the one before.
bool is_rising(const std::vector<double>& values);

/// The times of fields must rise, and lie within the times of the tests.
std::vector<std::string> mistakes_of_field_times(const std::vector<double>& field_times, const TimeWindow& times);

/// A mistake for each load that a box of so many dimensions does not have, with the loads that it has.
std::vector<std::string> mistakes_of_loads(const std::vector<TestLoad>& loads, int dimensions);

/// The model by which the stage is computed: films where the tests request them and the stage has grains, cells
/// otherwise.
Model model_of(const Tests& tests, const Stage& stage);

/// Whether tests of the stage save fields: tests of cells and of thin films do, at the field times of the tests.
bool has_fields(const Tests& tests, const Stage& stage);

/// What keeps a study from cells with flow through gaps, a line each: 'stage A: expected packing.walls other than
/// "cut"'. Empty where they support all that it requests.
std::vector<std::string> obstacles_to_flow(const Study& study);

/// The mixing of a study that names none: in two dimensions flow through gaps where it supports the study, cells in
/// series otherwise and in three dimensions, and points with standard volumetric strains.
Mixing default_mixing(const Study& study);

/// Contradictions between the parts of a study, each of which is allowed by itself: mixed cells with standard
/// volumetric strains, films along the walls under a boundary other than displacement, requests that the model of films
/// does not support, and too few times for the fits that the study needs.
std::vector<std::string> contradictions(const Study& study);

}  // namespace breccia
