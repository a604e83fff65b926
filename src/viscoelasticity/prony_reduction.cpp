#include "viscoelasticity/prony_reduction.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "viscoelasticity/common_times_search.hpp"

namespace breccia {
namespace {

/// The sum over all series of the deviation beyond the tolerance [-].
double excess_of(const PronyReduction& reduction, double tolerance) {
  double excess = 0.0;
  for (const double deviation : reduction.deviations) excess += std::max(0.0, deviation - tolerance);
  return excess;
}

/// Keeps the best of several reductions: the one that exceeds the tolerance least; among reductions within the
/// tolerance, the one with the fewest relaxation times; among these, the one with the least deviation.
class BestReduction {
 public:
  explicit BestReduction(const PronyReductionOptions& options) : options_(options) {}

  void consider(PronyReduction found) {
    if (found.relaxation_times() > options_.most_terms) return;
    if (found_.series.empty() || rank(found) < rank(found_)) found_ = std::move(found);
  }
  [[nodiscard]] const PronyReduction& found() const { return found_; }

 private:
  [[nodiscard]] std::tuple<double, std::size_t, double> rank(const PronyReduction& reduction) const {
    return {excess_of(reduction, options_.tolerance), reduction.relaxation_times(), reduction.worst_deviation()};
  }

  PronyReductionOptions options_;
  PronyReduction found_;
};

/// A modulus and its range of values in a window of time.
struct RelaxingModulus {
  PronySeries series;
  double least;  ///< least value [Pa]
  double most;   ///< largest value [Pa]

  RelaxingModulus(const PronySeries& modulus, const std::vector<double>& times) : series(modulus) {
    std::vector<double> values(times.size());
    std::ranges::transform(times, values.begin(), [&](double time) { return modulus.at(time); });
    const auto [smallest, largest] = std::ranges::minmax_element(values);
    least = *smallest;
    most = *largest;
    if (!(least > 0.0)) throw InputError(fmt::format("terms: expected a positive modulus, got {} Pa", least));
  }

  [[nodiscard]] double change() const { return most / least - 1.0; }
  [[nodiscard]] PronySeries middle() const { return PronySeries(std::sqrt(least * most)); }
  [[nodiscard]] double deviation_of_middle() const { return std::sqrt(most / least) - 1.0; }
};

/// Searches the fewest relaxation times with which series follow the moduli within the tolerance: 0, 4, 8, 16, ...,
/// then by bisection. Calls `consider` with every reduction found on the way. A number that suffices for one tolerance
/// suffices for a wider one, so that a wider one hardly ever takes more times. Where even a dense fit is far off, for
/// example for a modulus that rises, only the largest number of terms is tried.
void search_fewest_times(const CommonTimesSearch& times, const PronyReductionOptions& options,
                         const std::function<void(PronyReduction)>& consider) {
  const auto follows = [&](std::size_t count) {
    auto found = times.with(count);
    const bool is_within = found.worst_deviation() <= options.tolerance;
    consider(std::move(found));
    return is_within;
  };
  const auto most = std::min(times.most(), options.most_terms);
  constexpr std::size_t first = 4;
  constexpr double rest = 1.05;  // factor by which moving the times of a dense fit lowers its deviation at most
  const auto nearest = times.nearest(options.tolerance);
  consider(nearest);
  if (nearest.worst_deviation() > rest * options.tolerance) {
    if (options.most_terms < times.most()) follows(most);
    return;
  }
  std::size_t too_few = 0, enough = std::min(first, most);
  if (follows(0)) return;
  while (!follows(enough)) {
    if (enough == most) return;
    too_few = enough;
    enough = std::min(2 * enough, most);
  }
  while (enough - too_few > 1) {
    const auto middle = (enough + too_few) / 2;
    (follows(middle) ? enough : too_few) = middle;
  }
}

/// Considers the unchanged series, unless one has a negative term.
void consider_as_given(const std::vector<RelaxingModulus>& moduli, BestReduction& best) {
  PronyReduction given;
  for (const auto& [series, least, most] : moduli) {
    if (std::ranges::any_of(series.terms(), [](const MaxwellTerm& term) { return term.modulus < 0.0; })) return;
    given.series.push_back(series);
    given.deviations.push_back(0.0);
  }
  best.consider(std::move(given));
}

}  // namespace

std::size_t PronyReduction::relaxation_times() const {
  std::vector<double> times;
  for (const auto& one : series) {
    for (const auto& term : one.terms()) times.push_back(term.relaxation_time);
  }
  std::ranges::sort(times);
  return static_cast<std::size_t>(std::unique(times.begin(), times.end()) - times.begin());
}

double PronyReduction::worst_deviation() const {
  return deviations.empty() ? 0.0 : *std::ranges::max_element(deviations);
}

PronyReduction reduce_prony(std::span<const PronySeries> series, const TimeWindow& window,
                            const PronyReductionOptions& options) {
  if (!(window.begin > 0.0 && window.begin < window.end)) {
    throw InputError(fmt::format("terms: expected two rising times, got {} s and {} s", window.begin, window.end));
  }
  if (!(options.tolerance > 0.0)) {
    throw InputError(fmt::format("terms: expected a tolerance above zero, got {}", options.tolerance));
  }
  const auto times = checked_times(window);
  std::vector<RelaxingModulus> moduli;
  for (const auto& one : series) moduli.emplace_back(one, times);
  std::vector<std::size_t> by_change(moduli.size());
  std::iota(by_change.begin(), by_change.end(), std::size_t{0});
  std::ranges::stable_sort(by_change, std::greater<>(), [&](std::size_t i) { return moduli[i].change(); });
  const auto is_elastic = [&](std::size_t i) { return moduli[i].change() <= 0.5 * options.tolerance; };

  BestReduction best(options);
  consider_as_given(moduli, best);
  // The search is repeated with each modulus that is elastic for this tolerance among the relaxing ones, as it would be
  // for a narrower tolerance, so that a narrower tolerance never finds fewer terms.
  const auto relaxing = static_cast<std::size_t>(std::ranges::find_if(by_change, is_elastic) - by_change.begin());
  for (auto searched = relaxing; searched <= by_change.size(); ++searched) {
    if (searched > relaxing && moduli[by_change[searched - 1]].series.is_elastic()) break;
    std::vector<PronySeries> together;
    for (std::size_t i = 0; i < searched; ++i) together.push_back(moduli[by_change[i]].series);
    search_fewest_times(CommonTimesSearch(together, window), options, [&](const PronyReduction& found) {
      PronyReduction all{std::vector<PronySeries>(moduli.size()), std::vector<double>(moduli.size())};
      for (std::size_t i = 0; i < by_change.size(); ++i) {
        const auto at = by_change[i];
        all.series[at] = i < relaxing ? found.series[i] : moduli[at].middle();
        all.deviations[at] = i < relaxing ? found.deviations[i] : moduli[at].deviation_of_middle();
      }
      best.consider(std::move(all));
    });
  }
  return best.found();
}

}  // namespace breccia
