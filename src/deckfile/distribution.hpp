#pragma once

#include <functional>
#include <optional>
#include <string>

#include "breccia/probability/distribution.hpp"

#include "deckfile/deck.hpp"

namespace breccia {

/// How the numbers of a distribution are written in its table.
struct NumberReader {
  /// Reads the value of a key, within a range.
  std::function<double(const Section& table, const std::string& key, const Range& range)> value;
  /// Reads the standard deviation, which may have another dimension: that of a temperature is a difference.
  std::function<double(const Section& table, const std::string& key, const Range& range)> deviation;
};

/// Quantities of a dimension, or plain numbers without one.
NumberReader reader_of(std::optional<Dimension> dimension);
/// Fractions, as numbers or in per cent.
NumberReader reader_of_fractions();

/// Reads what is known of an uncertain number from the table of a key: `{ value = ..., sd = ... }`,
/// `{ value = ..., factor = 2 }`, `{ from = ..., to = ... }`, the last with `scale = "logarithmic"` or without. Only
/// distributions within `range` are accepted: a normal one has to be most_score standard deviations away from its
/// ends. Returns nothing after a mistake was reported.
std::optional<Distribution> read_distribution(const Section& section, const std::string& key,
                                              const NumberReader& reader, const Range& range);

}  // namespace breccia
