#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "breccia/assessment/find_input.hpp"
#include "breccia/deck/deck_assessment.hpp"
#include "breccia/deckfile/deck_setting.hpp"
#include "breccia/homogenisation/study_result.hpp"

#include "deck/condition.hpp"

namespace breccia {

/// The input of a deck that is to make its composite meet a condition.
struct SoughtInput {
  std::size_t index = 0;  ///< among the inputs of the deck
  Condition condition = {};
  std::optional<double> model_error = {};  ///< of the moduli [-]; nothing: the one that the study states
};

/// Reads what is sought, before anything of a deck is solved: `key` is the path of an uncertain input, or its last
/// steps. Throws InputError, with a line for each mistake.
SoughtInput read_sought_input(const DeckAssessment& deck, const std::string& key, const std::string& condition,
                              std::optional<double> model_error);

/// A value that makes a composite meet a condition.
struct FoundDesign {
  double value = 0.0;  ///< of the input in the SI unit, with the medians of the others
  double lower = 0.0;  ///< end of the interval of 95 % in the SI unit; minus or plus infinity beyond the range
  double upper = 0.0;  ///< the other end
  bool has_model_error = false;  ///< whether the interval has the error of the model
  double without = 0.0;          ///< share of the cases in which no value of the range serves [-]
  /// What the composite has over the range that was searched: the quantity of the condition (as_written).
  std::vector<DesignPoint> points = {};
  std::vector<std::string> warnings = {};
};

/// Finds the sought input from the curves of all samples. An error of the model is taken as twice its standard
/// deviation. Throws InputError where no value serves, with the best that can be had, where several do, and where the
/// boxes do not tell what the input changes.
FoundDesign find_input(const DeckAssessment& deck, const std::vector<SampledCurve>& curves, const SoughtInput& sought);

/// A value of an input, to four digits, as a deck has it: 0.5073, "131.2 MPa".
Scalar rounded_value(const UncertainInput& input, double value);

/// The warning where the study with the value that was found has a quantity outside of what was expected; else empty.
std::string doubt_on(const FoundDesign& design, const Condition& condition, double reached);

/// The quantity of a condition that a stage of a solved study has (as_written), from the results of all its stages.
double value_of_study(const std::vector<StageFindings>& stages, const std::string& stage, const Condition& condition);

}  // namespace breccia
