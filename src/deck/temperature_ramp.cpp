#include "temperature_ramp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

constexpr double ice_point = 273.15;

/// The moduli of one frequency by rising temperature.
struct Course {
  double frequency = 0.0;
  std::vector<double> temperatures, log_storage, log_loss;

  /// M' and M'' at a temperature within those of the course, or below them by rounding.
  [[nodiscard]] std::array<double, 2> at(double temperature) const {
    const auto above = std::ranges::lower_bound(temperatures, temperature);
    const auto i = static_cast<std::size_t>(above - temperatures.begin());
    if (i == 0 || *above == temperature) return {std::exp(log_storage[i]), std::exp(log_loss[i])};
    const double share = (temperature - temperatures[i - 1]) / (temperatures[i] - temperatures[i - 1]);
    return {std::exp(std::lerp(log_storage[i - 1], log_storage[i], share)),
            std::exp(std::lerp(log_loss[i - 1], log_loss[i], share))};
  }
};

/// Whole multiples of a step of 1, 2, 5, 10 or 20 degrees Celsius between two temperatures [K].
std::vector<double> round_temperatures(double lowest, double highest) {
  constexpr std::array steps{1.0, 2.0, 5.0, 10.0, 20.0};
  constexpr double most = 50.0;
  const auto* step = std::ranges::find_if(steps, [&](double one) { return (highest - lowest) / one < most; });
  const double width = step == steps.end() ? steps.back() : *step;
  std::vector<double> temperatures;
  for (double multiple = std::ceil((lowest - ice_point) / width); multiple * width + ice_point <= highest;
       multiple += 1.0) {
    temperatures.push_back(multiple * width + ice_point);
  }
  return temperatures;
}

/// The rows of each frequency, by rising temperature.
std::vector<std::vector<std::size_t>> rows_by_frequency(std::span<const double> frequencies,
                                                        std::span<const double> temperatures) {
  std::vector<std::size_t> all(frequencies.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::stable_sort(all, {}, [&](std::size_t row) { return frequencies[row]; });
  constexpr double rounding = 1.001;
  std::vector<std::vector<std::size_t>> groups;
  for (const auto row : all) {
    if (groups.empty() || frequencies[row] > rounding * frequencies[groups.back().front()]) groups.emplace_back();
    groups.back().push_back(row);
  }
  for (auto& rows : groups) {
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return temperatures[row]; });
  }
  return groups;
}

}  // namespace

DynamicData sweeps_of_ramp(const std::filesystem::path& path, std::span<const double> temperatures,
                           std::span<const double> frequencies, std::span<const double> storage,
                           std::span<const double> loss) {
  std::vector<Course> courses;
  for (const auto& rows : rows_by_frequency(frequencies, temperatures)) {
    Course course{frequencies[rows.front()], {}, {}, {}};
    for (const auto row : rows) {
      if (!course.temperatures.empty() && temperatures[row] <= course.temperatures.back()) continue;
      course.temperatures.push_back(temperatures[row]);
      course.log_storage.push_back(std::log(storage[row]));
      course.log_loss.push_back(std::log(loss[row]));
    }
    courses.push_back(std::move(course));
  }
  double lowest = 0.0, highest = HUGE_VAL;
  for (const auto& course : courses) {
    lowest = std::max(lowest, course.temperatures.front());
    highest = std::min(highest, course.temperatures.back());
  }
  const auto common = round_temperatures(lowest, highest);
  constexpr std::size_t fewest = 2;
  if (courses.size() < fewest || common.size() < fewest) {
    throw InputError(fmt::format(
        "{}: the temperature changes through the measurement, so at least two frequencies at the same temperatures are "
        "needed, got {} from {:.4g} to {:.4g} degC",
        path.string(), courses.size() == 1 ? "one frequency" : fmt::format("{} frequencies", courses.size()),
        lowest - ice_point, highest - ice_point));
  }
  DynamicData data;
  data.is_of_ramp = true;
  for (const double temperature : common) {
    FrequencySweep sweep{temperature, {}, {}, {}};
    for (const auto& course : courses) {
      const auto [stored, lost] = course.at(temperature);
      sweep.frequencies.push_back(course.frequency);
      sweep.storage.push_back(stored);
      sweep.loss.push_back(lost);
    }
    data.sweeps.push_back(std::move(sweep));
  }
  return data;
}

}  // namespace breccia
