#pragma once

#include <string>
#include <string_view>

#include "breccia/assessment/observation.hpp"

namespace breccia {

/// How the value of a condition is written.
enum class ConditionForm { modulus, angle, tangent };

/// A wish that a composite shall meet, such as `G(1 ms) = 3 GPa` or `tan_delta(10 Hz) = 0.3`.
struct Condition {
  std::string quantity;  ///< as it was written: `tan_delta(10 Hz)`
  ConditionForm form = ConditionForm::modulus;
  Observation wanted = {};  ///< without noise
};

/// Reads a condition. Throws InputError where it is none.
///
/// G, K, E and M = K + 4 G / 3 are relaxation moduli at a time; with one or two primes, or between bars and with an
/// asterisk, they are storage and loss modulus, and the absolute value of the complex modulus, at a frequency.
/// `tan_delta` and `phase` are those of G at a frequency.
Condition read_condition(const std::string& text);

/// The value of the quantity of a condition from that of the observation, in the SI unit: tan(delta) of a phase.
double as_written(const Condition& condition, double observed);

/// The SI unit of the quantity of a condition; empty without one.
std::string_view unit_of(const Condition& condition);

/// A value of the quantity of a condition in words: `2.9 GPa`, `17 deg`, `0.31`.
std::string value_in_words(const Condition& condition, double value);

}  // namespace breccia
