#include "virtual_test/stitching.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include <fmt/format.h>

#include "breccia/error.hpp"

namespace breccia {
namespace {

bool contains(const TimeWindow& window, double time) {
  constexpr double rounding = 1e-9;
  return time >= window.begin * (1.0 - rounding) && time <= window.end * (1.0 + rounding);
}

double modulus_at(const TimeDomain& domain, double time) {
  // Samples in the window are used, and one sample on either side for interpolation at its ends.
  auto begin = std::ranges::lower_bound(domain.history, domain.window.begin, {}, &Sample::time);
  auto end = std::ranges::upper_bound(domain.history, domain.window.end, {}, &Sample::time);
  if (begin != domain.history.begin()) --begin;
  if (end != domain.history.end()) ++end;
  const std::span<const Sample> valid(begin, end);
  return smoothed_at(valid, std::clamp(time, valid.front().time, valid.back().time));
}

}  // namespace

Curve stitch(const std::vector<TimeDomain>& domains, const TimeWindow& times, int points_per_decade) {
  for (std::size_t i = 0; i + 1 < domains.size(); ++i) {
    if (domains[i + 1].window.begin > domains[i].window.end) {
      throw NumericalError(fmt::format(
          "time domains: none is valid between {:.3e} and {:.3e} s; give mass scaling factors whose windows overlap",
          domains[i].window.end, domains[i + 1].window.begin));
    }
  }
  Curve curve;
  for (const double time : logarithmic_times(times, points_per_decade)) {
    const auto valid = [&](const TimeDomain& domain) { return contains(domain.window, time); };
    const auto first = std::ranges::find_if(domains, valid);
    if (first == domains.end()) {
      throw NumericalError(fmt::format(
          "time domains: none is valid at {:.3e} s; give mass scaling factors whose windows cover the times", time));
    }
    double modulus = modulus_at(*first, time);
    // The weight of each domain rises from 0 to 1 over its overlap with the domain before it.
    for (auto later = std::next(first); later != domains.end() && valid(*later); ++later) {
      const double width = std::log(std::prev(later)->window.end / later->window.begin);
      const double share = width > 0.0 ? std::clamp(std::log(time / later->window.begin) / width, 0.0, 1.0) : 1.0;
      modulus += share * (modulus_at(*later, time) - modulus);
    }
    curve.push_back({time, modulus});
  }
  return curve;
}

std::vector<Overlap> compare_overlaps(const std::vector<TimeDomain>& domains, int points_per_decade) {
  std::vector<Overlap> overlaps;
  for (std::size_t i = 0; i + 1 < domains.size(); ++i) {
    const auto& [earlier, later] = std::tie(domains[i], domains[i + 1]);
    Overlap overlap{{later.window.begin, earlier.window.end}};
    if (overlap.window.end < overlap.window.begin) continue;
    for (const double time : logarithmic_times(overlap.window, 4 * points_per_decade)) {
      const double a = modulus_at(earlier, time), b = modulus_at(later, time);
      overlap.mismatch = std::max(overlap.mismatch, std::abs(b / a - 1.0));
    }
    overlaps.push_back(overlap);
  }
  return overlaps;
}

}  // namespace breccia
