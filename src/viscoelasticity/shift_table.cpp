#include "breccia/viscoelasticity/shift_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "viscoelasticity/temperature_text.hpp"

namespace breccia {
namespace {

/// The value y at x of the piecewise linear function through points with rising x, on the given section.
double on_section(std::span<const double> x, std::span<const double> y, std::size_t section, double at) {
  const double share = (at - x[section]) / (x[section + 1] - x[section]);
  return (1.0 - share) * y[section] + share * y[section + 1];
}

}  // namespace

ShiftTable::ShiftTable(std::vector<double> temperatures, std::vector<double> log10_factors,
                       double reference_temperature)
    : temperatures_(std::move(temperatures)),
      log10_factors_(std::move(log10_factors)),
      reference_temperature_(reference_temperature) {
  std::vector<std::string> mistakes;
  if (temperatures_.size() != log10_factors_.size() || temperatures_.size() < 2) {
    throw InputError("a table of shift factors: expected at least two temperatures, each with its factor");
  }
  const auto is_in_range = [](double log10_factor) { return std::abs(log10_factor) <= most_decades; };
  if (!std::ranges::all_of(temperatures_, [](double kelvin) { return kelvin > 0.0 && std::isfinite(kelvin); })) {
    throw InputError("a table of shift factors: expected temperatures above absolute zero");
  }
  if (!std::ranges::all_of(log10_factors_, is_in_range)) {
    throw InputError("a table of shift factors: expected factors between 1e-100 and 1e100");
  }
  const auto out_of_order = std::ranges::adjacent_find(temperatures_, std::greater_equal{});
  if (out_of_order != temperatures_.end()) {
    mistakes.push_back(fmt::format("a table of shift factors: expected rising temperatures, got {} after {}",
                                   in_kelvin_and_celsius(out_of_order[1]), in_kelvin_and_celsius(out_of_order[0])));
  }
  const auto rising = std::ranges::adjacent_find(log10_factors_, std::less_equal{});
  if (rising != log10_factors_.end()) {
    const auto at = static_cast<std::size_t>(rising - log10_factors_.begin()) + 1;
    mistakes.push_back(
        fmt::format("a table of shift factors: expected factors that fall as the temperature rises, got "
                    "log10 a_T = {} after {} at {}",
                    rising[1], rising[0], in_kelvin_and_celsius(temperatures_[at])));
  }
  if (!mistakes.empty()) throw InputError(fmt::format("{}", fmt::join(mistakes, "\n")));
  const double at_reference = log10_factor(reference_temperature_);
  for (auto& factor : log10_factors_) factor -= at_reference;
}

double ShiftTable::log10_factor(double temperature) const {
  // A row may be written in another unit than an equal temperature elsewhere.
  constexpr double rounding = 1e-6;  // [K]
  const auto is_row = [temperature](double row) { return std::abs(temperature - row) <= rounding; };
  if (const auto row = std::ranges::find_if(temperatures_, is_row); row != temperatures_.end()) {
    return log10_factors_[static_cast<std::size_t>(row - temperatures_.begin())];
  }
  if (!(temperature >= temperatures_.front() && temperature <= temperatures_.back())) {
    throw InputError(fmt::format("the table of shift factors reaches from {} to {}, got {}",
                                 in_kelvin_and_celsius(temperatures_.front()),
                                 in_kelvin_and_celsius(temperatures_.back()), in_kelvin_and_celsius(temperature)));
  }
  const auto above = std::upper_bound(temperatures_.begin() + 1, temperatures_.end() - 1, temperature);
  return on_section(temperatures_, log10_factors_, static_cast<std::size_t>(above - temperatures_.begin()) - 1,
                    temperature);
}

double ShiftTable::shift_factor(double temperature) const {
  return std::pow(10.0, log10_factor(temperature));
}

double ShiftTable::temperature_at(double log10_factor) const {
  const double covered = std::clamp(log10_factor, log10_factors_.back(), log10_factors_.front());
  const auto below = std::upper_bound(log10_factors_.begin() + 1, log10_factors_.end() - 1, covered, std::greater{});
  return on_section(log10_factors_, temperatures_, static_cast<std::size_t>(below - log10_factors_.begin()) - 1,
                    covered);
}

}  // namespace breccia
