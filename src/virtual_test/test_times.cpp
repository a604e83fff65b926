#include "virtual_test/test_times.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {

void require_times(std::string_view test, const TimeWindow& times, int points_per_decade,
                   const std::vector<double>& field_times) {
  if (!(times.begin > 0.0) || !(times.end >= times.begin)) {
    throw InputError(fmt::format("{}: expected rising positive times, got {} to {} s", test, times.begin, times.end));
  }
  if (points_per_decade < 1) {
    throw InputError(fmt::format("{}: expected at least one point per decade, got {}", test, points_per_decade));
  }
  const auto is_within = [&](double time) { return times.begin <= time && time <= times.end; };
  if (!std::ranges::all_of(field_times, is_within) || !std::ranges::is_sorted(field_times, std::less_equal())) {
    throw InputError(
        fmt::format("{}: expected rising times of fields between {} and {} s", test, times.begin, times.end));
  }
}

}  // namespace breccia
