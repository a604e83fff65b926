#include "breccia/viscoelasticity/few_terms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/viscoelasticity/fit.hpp"

namespace breccia {
namespace {

/// Times in a window, equally spaced in their logarithms, both ends included.
std::vector<double> sampled_times(const TimeWindow& window, int per_decade) {
  const double decades = std::log10(window.end / window.begin);
  const auto count = std::max(8, static_cast<int>(std::ceil(per_decade * decades)));
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(window.begin * std::pow(10.0, decades * i / count));
  times.push_back(window.end);
  return times;
}

std::vector<double> moduli_at(const PronySeries& series, const std::vector<double>& times) {
  std::vector<double> moduli(times.size());
  std::ranges::transform(times, moduli.begin(), [&](double time) { return series.at(time); });
  return moduli;
}

double largest_deviation(const PronySeries& series, const std::vector<double>& times,
                         const std::vector<double>& expected) {
  double largest = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    largest = std::max(largest, std::abs(series.at(times[i]) / expected[i] - 1.0));
  }
  return largest;
}

/// The constant in the middle of moduli that change by less than a tolerance; nothing for others.
std::optional<PronySeries> as_elastic(const std::vector<double>& moduli, double tolerance) {
  const auto [least, most] = std::ranges::minmax(moduli);
  if (most / least - 1.0 > 0.5 * tolerance) return std::nullopt;
  return PronySeries(std::sqrt(least * most));
}

}  // namespace

std::size_t FewTerms::relaxation_times() const {
  std::vector<double> times;
  for (const auto& one : series) {
    for (const auto& term : one.terms()) times.push_back(term.relaxation_time);
  }
  std::ranges::sort(times);
  const auto repeated = std::ranges::unique(times);
  return times.size() - repeated.size();
}

double FewTerms::worst_deviation() const {
  return deviations.empty() ? 0.0 : *std::ranges::max_element(deviations);
}

FewTerms with_few_terms(std::span<const PronySeries> series, const TimeWindow& window, const FewTermsOptions& options) {
  if (!(window.begin > 0.0 && window.begin < window.end)) {
    throw InputError(fmt::format("terms: expected two rising times, got {} s and {} s", window.begin, window.end));
  }
  if (!(options.tolerance > 0.0)) {
    throw InputError(fmt::format("terms: expected a tolerance above zero, got {}", options.tolerance));
  }
  constexpr int fitted_per_decade = 20, checked_per_decade = 40;
  const auto fitted = sampled_times(window, fitted_per_decade), checked = sampled_times(window, checked_per_decade);
  std::vector<std::vector<double>> at_fitted, at_checked;
  for (const auto& one : series) {
    at_fitted.push_back(moduli_at(one, fitted));
    at_checked.push_back(moduli_at(one, checked));
    const double least = *std::ranges::min_element(at_checked.back());
    if (!(least > 0.0)) throw InputError(fmt::format("terms: expected a positive modulus, got {} Pa", least));
  }

  constexpr std::array times_per_decade = {0.3,  0.4, 0.5,  0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2,
                                           1.35, 1.5, 1.75, 2.0, 2.5, 3.0, 4.0, 6.0, 10.0};
  FewTerms best;
  for (const double density : times_per_decade) {
    FewTerms found;
    for (std::size_t i = 0; i < series.size(); ++i) {
      const auto elastic = as_elastic(at_checked[i], options.tolerance);
      found.series.push_back(elastic ? *elastic
                                     : fit_relaxation(fitted, at_fitted[i], {.times_per_decade = density}).series);
      found.deviations.push_back(largest_deviation(found.series.back(), checked, at_checked[i]));
    }
    const bool is_few = found.relaxation_times() <= options.most_terms;
    const bool is_better = best.series.empty() || found.worst_deviation() < best.worst_deviation();
    if (is_better && (is_few || best.series.empty())) best = std::move(found);
    if (best.worst_deviation() <= options.tolerance) break;
  }
  return best;
}

}  // namespace breccia
