#include "deck/time_window.hpp"

#include <numbers>

namespace breccia {

namespace {

/// Reads two rising frequencies as the times 1 / (2 pi f).
std::optional<TimeWindow> read_frequency_window(const Section& section) {
  const auto frequencies = section.quantities("frequencies", Dimension::frequency, Range::positive());
  if (frequencies.empty()) return {};
  // An invalid frequency has been reported already and is NaN here.
  if (frequencies.size() == 2 && !(frequencies[0] >= frequencies[1])) {
    const auto time_of = [](double frequency) { return 1.0 / (2.0 * std::numbers::pi * frequency); };
    return TimeWindow{time_of(frequencies[1]), time_of(frequencies[0])};
  }
  section.report("frequencies", R"(expected two rising frequencies, such as ["0.01 Hz", "100 Hz"])");
  return {};
}

}  // namespace

std::optional<TimeWindow> read_time_window(const Section& section, const std::string& key) {
  const auto times = section.quantities(key, Dimension::time, Range::positive());
  if (times.empty()) return {};
  // An invalid time has been reported already and is NaN here.
  if (times.size() == 2 && !(times[0] >= times[1])) return TimeWindow{times[0], times[1]};
  section.report(key, R"(expected two rising times, such as ["10 ns", "10 ms"])");
  return {};
}

std::optional<TimeWindow> read_times_or_frequencies(const Section& section) {
  if (!section.has("frequencies")) {
    if (section.has("times")) return read_time_window(section, "times");
    section.report("times",
                   R"(missing, expected two rising times, such as ["10 ns", "10 ms"], or frequencies instead)");
    return {};
  }
  section.refuse({"times"}, "expected times or frequencies, got both");
  return read_frequency_window(section);
}

}  // namespace breccia
