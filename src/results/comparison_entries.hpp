#pragma once

#include <optional>
#include <string>
#include <tuple>

#include "breccia/discretisation/boundary.hpp"
#include "breccia/study/tests.hpp"
#include "breccia/tables/modulus_kind.hpp"

#include "results/json_fields.hpp"

namespace breccia {

// The entries for comparisons with measurements in `study.json` (study_document.hpp).

struct RatioEntry {
  double time = 0.0;  ///< [s]
  double ratio = 0.0;
};
template <>
inline constexpr auto fields<RatioEntry> = std::tuple(field("time_s", &RatioEntry::time),
                                                      field("ratio", &RatioEntry::ratio));

struct FrequencyRatioEntry {
  double frequency = 0.0;  ///< [Hz]
  double ratio = 0.0;
};
template <>
inline constexpr auto fields<FrequencyRatioEntry> = std::tuple(field("frequency_Hz", &FrequencyRatioEntry::frequency),
                                                               field("ratio", &FrequencyRatioEntry::ratio));

struct ComparisonEntry {
  std::string measurement;
  /// Results of earlier versions have no kind: all measurements were of the shear modulus.
  std::optional<ModulusKind> modulus = {};
  Boundary boundary = {};
  Method method = {};
  std::optional<RatioEntry> best = {}, worst = {};
  std::optional<FrequencyRatioEntry> best_in_frequency = {}, worst_in_frequency = {};
};
template <>
inline constexpr auto fields<ComparisonEntry> =
    std::tuple(field("measurement", &ComparisonEntry::measurement), field_if_any("modulus", &ComparisonEntry::modulus),
               field("boundary", &ComparisonEntry::boundary), field("method", &ComparisonEntry::method),
               field_if_any("best", &ComparisonEntry::best), field_if_any("worst", &ComparisonEntry::worst),
               field_if_any("best_in_frequency", &ComparisonEntry::best_in_frequency),
               field_if_any("worst_in_frequency", &ComparisonEntry::worst_in_frequency));

}  // namespace breccia
