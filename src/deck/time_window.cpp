#include "time_window.hpp"

namespace breccia {

std::optional<TimeWindow> read_time_window(const Section& section, const std::string& key) {
  const auto times = section.quantities(key, Dimension::time, Range::positive());
  if (times.empty()) return {};
  // An invalid time has been reported already and is NaN here.
  if (times.size() == 2 && !(times[0] >= times[1])) return TimeWindow{times[0], times[1]};
  section.report(key, R"(expected two rising times, such as ["10 ns", "10 ms"])");
  return {};
}

}  // namespace breccia
