#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "breccia/study/tests.hpp"

namespace breccia {

/// A time [s] or an angular frequency [rad/s] of a curve as axes show it: a time [s], a frequency [Hz].
double axis_value(double at, Abscissa abscissa);

/// The indices of the times or angular frequencies of a curve that are nearest to whole decades, as axes show them.
std::vector<std::size_t> decades_of(const std::vector<double>& at, Abscissa abscissa);

/// A time or an angular frequency in words: "10 ms", "10 Hz".
std::string place_in_words(double at, Abscissa abscissa);

}  // namespace breccia
