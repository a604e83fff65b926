#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "breccia/deckfile/deck_setting.hpp"
#include "breccia/probability/distribution.hpp"

namespace breccia {

/// Values of which each is as likely as the others.
struct Choices {
  std::vector<Scalar> values = {};
};

/// An input of a study that is not certain. It does not depend on the other inputs.
///
/// A coordinate stands for a value of it: the score of a distribution, the index of a choice.
struct UncertainInput {
  std::string name = {};                           ///< path of its key in a deck, as in `--set`: `materials.hmx.shear`
  std::string unit = {};                           ///< SI unit of the values of a distribution; empty without one
  std::variant<Distribution, Choices> known = {};  ///< what is known of it
};

/// The number of choices; 0 for a distribution.
std::size_t choices_of(const UncertainInput& input);

/// The value at a coordinate, as a deck has it: `"5.84e+09 Pa"`, `0.62`.
Scalar value_at(const UncertainInput& input, double coordinate);

}  // namespace breccia
