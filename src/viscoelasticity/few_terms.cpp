#include "breccia/viscoelasticity/few_terms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Core>
#include <fmt/format.h>

#include "breccia/error.hpp"

#include "non_negative_least_squares.hpp"

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

/// Relaxation times at a spacing [1/decade], from a third of the first to three times the last time of a window. An
/// offset between 0 and 1 moves them by that share of the spacing.
std::vector<double> relaxation_times_at(const TimeWindow& window, double per_decade, double offset) {
  constexpr double beyond = 3.0;
  const double first = std::log10(window.begin / beyond), last = std::log10(window.end * beyond);
  std::vector<double> times;
  for (int i = 0; first + (i + offset) / per_decade <= last; ++i) {
    times.push_back(std::pow(10.0, first + (i + offset) / per_decade));
  }
  return times;
}

/// The non-negative series of these relaxation times with the least squares of the relative deviations (theory, Eq.
/// 24).
PronySeries fitted_series(const std::vector<double>& relaxation_times, const std::vector<double>& times,
                          const std::vector<double>& moduli) {
  const auto rows = static_cast<Eigen::Index>(times.size());
  const auto terms = static_cast<Eigen::Index>(relaxation_times.size());
  Eigen::MatrixXd relative(rows, terms + 1);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto at = static_cast<std::size_t>(i);
    for (Eigen::Index k = 0; k < terms; ++k) {
      relative(i, k) = std::exp(-times[at] / relaxation_times[static_cast<std::size_t>(k)]) / moduli[at];
    }
    relative(i, terms) = 1.0 / moduli[at];
  }
  const Eigen::VectorXd strengths = non_negative_least_squares(relative, Eigen::VectorXd::Ones(rows));
  std::vector<MaxwellTerm> used;
  for (Eigen::Index k = 0; k < terms; ++k) {
    if (strengths[k] > 0.0) used.push_back({relaxation_times[static_cast<std::size_t>(k)], strengths[k]});
  }
  return {strengths[terms], std::move(used)};
}

/// The constant in the middle of moduli that change by less than a tolerance; nothing for others.
std::optional<PronySeries> as_elastic(const std::vector<double>& moduli, double tolerance) {
  const auto [least, most] = std::ranges::minmax(moduli);
  if (most / least - 1.0 > 0.5 * tolerance) return std::nullopt;
  return PronySeries(std::sqrt(least * most));
}

/// By how much the deviations of all series exceed the tolerance.
double excess_of(const FewTerms& terms, double tolerance) {
  double excess = 0.0;
  for (const double deviation : terms.deviations) excess += std::max(0.0, deviation - tolerance);
  return excess;
}

}  // namespace

std::size_t FewTerms::relaxation_times() const {
  std::vector<double> times;
  for (const auto& one : series) {
    for (const auto& term : one.terms()) times.push_back(term.relaxation_time);
  }
  std::ranges::sort(times);
  return static_cast<std::size_t>(std::unique(times.begin(), times.end()) - times.begin());
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
  constexpr std::array offsets = {0.0, 0.25, 0.5, 0.75};
  FewTerms best;
  for (const double density : times_per_decade) {
    for (const double offset : offsets) {
      const auto relaxation_times = relaxation_times_at(window, density, offset);
      FewTerms found;
      for (std::size_t i = 0; i < series.size(); ++i) {
        const auto elastic = as_elastic(at_checked[i], options.tolerance);
        found.series.push_back(elastic ? *elastic : fitted_series(relaxation_times, fitted, at_fitted[i]));
        found.deviations.push_back(largest_deviation(found.series.back(), checked, at_checked[i]));
      }
      const bool is_first = best.series.empty();
      const bool is_few = found.relaxation_times() <= options.most_terms;
      const bool is_better = is_first || excess_of(found, options.tolerance) < excess_of(best, options.tolerance);
      if (is_better && (is_first || is_few)) best = std::move(found);
    }
    if (excess_of(best, options.tolerance) == 0.0) break;
  }
  return best;
}

}  // namespace breccia
