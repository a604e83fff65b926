#include "breccia/viscoelasticity/few_terms.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "few_times.hpp"

namespace breccia {
namespace {

/// By how much the deviations of all series exceed the tolerance.
double excess_of(const FewTerms& terms, double tolerance) {
  double excess = 0.0;
  for (const double deviation : terms.deviations) excess += std::max(0.0, deviation - tolerance);
  return excess;
}

/// Keeps the best of several choices: the nearest to the tolerance, of those within it that of fewest terms, and of
/// these that of the least deviation.
class Best {
 public:
  explicit Best(const FewTermsOptions& options) : options_(options) {}

  void consider(FewTerms found) {
    if (found.relaxation_times() > options_.most_terms) return;
    if (found_.series.empty() || rank(found) < rank(found_)) found_ = std::move(found);
  }
  [[nodiscard]] const FewTerms& found() const { return found_; }

 private:
  [[nodiscard]] std::tuple<double, std::size_t, double> rank(const FewTerms& terms) const {
    return {excess_of(terms, options_.tolerance), terms.relaxation_times(), terms.worst_deviation()};
  }

  FewTermsOptions options_;
  FewTerms found_;
};

/// A modulus, and between which values it changes in a window of time.
struct RelaxingModulus {
  PronySeries series;
  double least;  ///< [Pa]
  double most;   ///< [Pa]

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

/// Tells of series with different numbers of relaxation times, until the fewest that follow the moduli within the
/// tolerance are found: 0, 4, 8, 16, ..., and then by halves between those that do not and those that do. A number that
/// suffices for one tolerance suffices for a wider one, so a wider one hardly ever takes more. Where even a dense fit
/// is far off, as from a modulus that rises, only the most terms are tried.
void search_fewest(const FewTimes& times, const FewTermsOptions& options,
                   const std::function<void(FewTerms)>& consider) {
  const auto follows = [&](std::size_t count) {
    auto found = times.with(count);
    const bool is_within = found.worst_deviation() <= options.tolerance;
    consider(std::move(found));
    return is_within;
  };
  const auto most = std::min(times.most(), options.most_terms);
  constexpr std::size_t first = 4;
  constexpr double rest = 1.05;  // moving the times of a dense fit gains hardly more
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

/// The series as they are, unless one has a negative term.
void consider_as_given(const std::vector<RelaxingModulus>& moduli, Best& best) {
  FewTerms given;
  for (const auto& [series, least, most] : moduli) {
    if (std::ranges::any_of(series.terms(), [](const MaxwellTerm& term) { return term.modulus < 0.0; })) return;
    given.series.push_back(series);
    given.deviations.push_back(0.0);
  }
  best.consider(std::move(given));
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
  const auto times = checked_times(window);
  std::vector<RelaxingModulus> moduli;
  for (const auto& one : series) moduli.emplace_back(one, times);
  std::vector<std::size_t> by_change(moduli.size());
  std::iota(by_change.begin(), by_change.end(), std::size_t{0});
  std::ranges::stable_sort(by_change, std::greater<>(), [&](std::size_t i) { return moduli[i].change(); });
  const auto is_elastic = [&](std::size_t i) { return moduli[i].change() <= 0.5 * options.tolerance; };

  Best best(options);
  consider_as_given(moduli, best);
  // Those that are elastic for this tolerance are searched with, too, as for a narrower one, lest that find fewer
  // terms.
  const auto relaxing = static_cast<std::size_t>(std::ranges::find_if(by_change, is_elastic) - by_change.begin());
  for (auto searched = relaxing; searched <= by_change.size(); ++searched) {
    if (searched > relaxing && moduli[by_change[searched - 1]].series.is_elastic()) break;
    std::vector<PronySeries> together;
    for (std::size_t i = 0; i < searched; ++i) together.push_back(moduli[by_change[i]].series);
    search_fewest(FewTimes(together, window), options, [&](const FewTerms& found) {
      FewTerms all{std::vector<PronySeries>(moduli.size()), std::vector<double>(moduli.size())};
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
