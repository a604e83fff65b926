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
  Scalar value = {};  ///< with the medians of the other inputs, to four digits, as a deck has it
  std::optional<double> lower = {}, upper = {};  ///< ends of 95 % in the SI unit; nothing beyond the range
  /// What the composite has over the range that was searched: the quantity of the condition (as_written).
  std::vector<DesignPoint> points = {};
  std::vector<std::string> warnings = {};
};

/// Finds the sought input from the curves of all samples. An error of the model is taken as twice its standard
/// deviation. Throws InputError where no value serves, with the best that can be had, and where several do.
FoundDesign find_input(const DeckAssessment& deck, const std::vector<SampledCurve>& curves, const SoughtInput& sought);

/// The quantity of a condition that a stage of a solved study has (as_written), from the results of all its stages.
double value_of_study(const std::vector<StageFindings>& stages, const std::string& stage, const Condition& condition);

}  // namespace breccia
