#include "study/abscissa_words.hpp"

#include <numbers>

#include <fmt/format.h>

#include "io/display.hpp"
#include "io/units.hpp"

namespace breccia {

double hertz_of(double time) {
  return 1.0 / (2.0 * std::numbers::pi * time);
}

std::array<double, 2> hertz_within(const TimeWindow& times) {
  return {rounded_up_to_two_digits(hertz_of(times.end)), rounded_down_to_two_digits(hertz_of(times.begin))};
}

std::string display_in(Abscissa abscissa, double time) {
  return abscissa == Abscissa::time ? display_time(time) : display(hertz_of(time), "Hz");
}

std::string readable_in(Abscissa abscissa, double time) {
  return abscissa == Abscissa::time ? readable(time, Dimension::time) : display_in(abscissa, time);
}

std::string window_in(Abscissa abscissa, const TimeWindow& times) {
  const auto& [begin, end] = times;
  const bool rises = abscissa == Abscissa::time;
  return fmt::format("from {} to {}", readable_in(abscissa, rises ? begin : end),
                     readable_in(abscissa, rises ? end : begin));
}

}  // namespace breccia
