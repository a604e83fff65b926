#pragma once

#include <array>
#include <string>

#include "breccia/study/tests.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// The frequency [Hz] that belongs to a time [s]: 1 / (2 pi t).
double hertz_of(double time);

/// The first and the last of the frequencies [Hz] that belong to a window of times, rounded inwards to two digits.
std::array<double, 2> hertz_within(const TimeWindow& times);

/// A time [s] of a study as text, "282 ms", or the frequency that belongs to it, "564 mHz".
std::string display_in(Abscissa abscissa, double time);

/// The same, but a time as a deck may write it, with all of its digits.
std::string readable_in(Abscissa abscissa, double time);

/// A window of times, or of the frequencies that belong to them, from the smaller to the larger one: "from 1 ms to 1
/// s".
std::string window_in(Abscissa abscissa, const TimeWindow& times);

}  // namespace breccia
