#include "deck/temperature_ramp.hpp"

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

/// Largest distance of two temperatures between which moduli are interpolated [K].
constexpr double widest_gap = 6.0;

/// The moduli at one frequency by rising temperature.
struct Course {
  double frequency = 0.0;
  std::vector<double> temperatures, log_storage, log_loss;

  /// M' and M'' at a temperature within the range of the course, or below this range by rounding.
  [[nodiscard]] std::array<double, 2> at(double temperature) const {
    const auto above = std::ranges::lower_bound(temperatures, temperature);
    const auto i = static_cast<std::size_t>(above - temperatures.begin());
    if (i == 0 || *above == temperature) return {std::exp(log_storage[i]), std::exp(log_loss[i])};
    const double share = (temperature - temperatures[i - 1]) / (temperatures[i] - temperatures[i - 1]);
    return {std::exp(std::lerp(log_storage[i - 1], log_storage[i], share)),
            std::exp(std::lerp(log_loss[i - 1], log_loss[i], share))};
  }
  /// The distance between the two measured temperatures around a temperature [K].
  [[nodiscard]] double gap_at(double temperature) const {
    const auto above = std::ranges::lower_bound(temperatures, temperature);
    if (above == temperatures.begin() || *above == temperature) return 0.0;
    return *above - *(above - 1);
  }
};

/// The rows of each frequency, in the order of the file. Frequencies scatter by less than 2 %.
std::vector<std::vector<std::size_t>> rows_by_frequency(std::span<const double> frequencies) {
  std::vector<std::size_t> all(frequencies.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::stable_sort(all, {}, [&](std::size_t row) { return frequencies[row]; });
  constexpr double scatter = 1.02;
  std::vector<std::vector<std::size_t>> groups;
  for (const auto row : all) {
    if (groups.empty() || frequencies[row] > scatter * frequencies[groups.back().front()]) groups.emplace_back();
    groups.back().push_back(row);
  }
  for (auto& rows : groups) std::ranges::sort(rows);
  return groups;
}

/// Whether the temperature both rises and falls by kelvins through some rows.
bool turns(std::span<const double> temperatures, const std::vector<std::size_t>& rows) {
  constexpr double kelvins = 5.0;
  double lowest = HUGE_VAL, highest = 0.0, rise = 0.0, fall = 0.0;
  for (const auto row : rows) {
    lowest = std::min(lowest, temperatures[row]);
    highest = std::max(highest, temperatures[row]);
    rise = std::max(rise, temperatures[row] - lowest);
    fall = std::max(fall, highest - temperatures[row]);
  }
  return rise > kelvins && fall > kelvins;
}

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

/// The temperatures at which the moduli of all frequencies are interpolated.
std::vector<double> common_temperatures(const std::vector<Course>& courses) {
  double lowest = 0.0, highest = courses.empty() ? 0.0 : HUGE_VAL;
  for (const auto& course : courses) {
    lowest = std::max(lowest, course.temperatures.front());
    highest = std::min(highest, course.temperatures.back());
  }
  auto temperatures = round_temperatures(lowest, highest);
  std::erase_if(temperatures, [&](double temperature) {
    return std::ranges::any_of(courses, [&](const Course& one) { return one.gap_at(temperature) > widest_gap; });
  });
  return temperatures;
}

}  // namespace

DynamicData sweeps_of_ramp(const std::filesystem::path& path, std::span<const double> temperatures,
                           std::span<const double> frequencies, std::span<const double> storage,
                           std::span<const double> loss) {
  constexpr std::size_t fewest = 2;
  std::vector<Course> courses;
  for (auto& rows : rows_by_frequency(frequencies)) {
    if (rows.size() < fewest) continue;
    if (turns(temperatures, rows)) {
      throw InputError(
          fmt::format("{}: the temperature rises and falls: keep the rows of one direction", path.string()));
    }
    std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return temperatures[row]; });
    Course course;
    for (const auto row : rows) {
      course.frequency += frequencies[row] / static_cast<double>(rows.size());
      if (!course.temperatures.empty() && temperatures[row] <= course.temperatures.back()) continue;
      course.temperatures.push_back(temperatures[row]);
      course.log_storage.push_back(std::log(storage[row]));
      course.log_loss.push_back(std::log(loss[row]));
    }
    courses.push_back(std::move(course));
  }
  const auto common = common_temperatures(courses);
  if (courses.size() < fewest || common.size() < fewest) {
    throw InputError(fmt::format(
        "{}: the temperature changes through the measurement, so two frequencies are needed, both measured at least "
        "every {:g} K over the same temperatures; got {} at more than one temperature, and {} common whole degrees",
        path.string(), widest_gap, courses.size(), common.size()));
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
