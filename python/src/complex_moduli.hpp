#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "breccia/homogenisation/study_result.hpp"

namespace breccia::python {

/// The complex modulus of a test over frequency.
struct ComplexModuli {
  PronySeries series;  ///< relaxation modulus [Pa]
  std::vector<ComplexSample> samples = {};
  bool is_of_deck = false;  ///< whether the deck gives the frequencies
};

/// The complex modulus of a test at the frequencies of the deck or, where this gives times t, at the angular
/// frequencies 1/t.
ComplexModuli complex_moduli_of(const TestResult& test);

/// Adds complex moduli to the module.
void bind_complex_moduli(pybind11::module_& module);

}  // namespace breccia::python
