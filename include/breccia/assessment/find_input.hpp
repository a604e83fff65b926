#pragma once

#include <cstddef>
#include <vector>

#include "breccia/assessment/assess.hpp"
#include "breccia/assessment/interval.hpp"
#include "breccia/assessment/observation.hpp"
#include "breccia/deckfile/uncertain_input.hpp"

namespace breccia {

/// What a composite has at a value of the input that is sought.
struct DesignPoint {
  double input = 0.0;      ///< in its SI unit
  double value = 0.0;      ///< of the composite, with the medians of the other inputs, in the unit of what is wanted
  Interval interval = {};  ///< 95 % of the values, by the other inputs and the error of the model
};

/// An input by which a composite is to have a wanted value.
struct FoundInput {
  std::vector<DesignPoint> points = {};  ///< over the range that was searched, in rising order of the input
  /// Scores of the input at which the composite has the wanted value with the medians of the other inputs.
  std::vector<double> scores = {};
  /// Scores at the ends of the interval that holds 95 % of the values by which composites have what is wanted, as far
  /// as the other inputs and the error of the model leave them open; infinite where an end is beyond the range. They
  /// belong to the first of `scores`.
  double lower = 0.0, upper = 0.0;
  double without = 0.0;  ///< share of the cases in which no value of the range serves [-]
};

/// Searches the range of an input for values by which the composite has a wanted value, the value of an observation,
/// by polynomials in the inputs that follow the curves of samples (theory, section 20). All of a distribution with ends
/// is searched, and of others what was sampled. `model_deviation` is the relative standard deviation of the composite
/// from its model [-]; the error of the polynomials is added to it. Throws InputError as require_observable().
FoundInput find_input(const std::vector<UncertainInput>& inputs, std::size_t sought, const AssessmentDesign& design,
                      const std::vector<SampledCurve>& curves, const Observation& wanted, double model_deviation);

}  // namespace breccia
