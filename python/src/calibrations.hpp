#pragma once

#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "breccia/assessment/calibrate.hpp"
#include "breccia/assessment/observation.hpp"
#include "breccia/tables/modulus_kind.hpp"

namespace breccia::python {

/// The kind of modulus that a word names; not specified without a word. Throws InputError for another word.
ModulusKind modulus_named(const std::optional<std::string>& word);

/// What the class Calibration of Python is made of; `composites` are the names of those that were observed.
pybind11::dict calibration_entries(const std::vector<std::string>& composites,
                                   const std::vector<Observation>& observations, const Calibration& found,
                                   const std::vector<std::string>& notes);

/// Adds the calibration of materials to the module.
void bind_calibrations(pybind11::module_& module);

}  // namespace breccia::python
