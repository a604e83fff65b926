#include "viscoelasticity/common_times_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "viscoelasticity/merged_times.hpp"

namespace breccia {
namespace {

/// Factors by which the range of the relaxation times extends beyond both ends of a window: terms beyond it have
/// vanished at the first time, or are constant up to the last.
constexpr double beyond_begin = 30.0, beyond_end = 100.0;

/// Times of a window, equally spaced in their logarithms, both ends included [s].
std::vector<double> sampled_times(const TimeWindow& window, int per_decade) {
  constexpr int fewest = 24;
  const double decades = std::log10(window.end / window.begin);
  const auto count = std::max(fewest, static_cast<int>(std::ceil(per_decade * decades)));
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i < count; ++i) times.push_back(window.begin * std::pow(10.0, decades * i / count));
  times.push_back(window.end);
  return times;
}

/// The largest relative deviation of a series from moduli [Pa] at these times [s].
double largest_deviation(const PronySeries& series, const std::vector<double>& times,
                         const std::vector<double>& moduli) {
  double largest = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    largest = std::max(largest, std::abs(series.at(times[i]) / moduli[i] - 1.0));
  }
  return largest;
}

std::vector<double> moduli_at(const PronySeries& series, const std::vector<double>& times) {
  std::vector<double> moduli(times.size());
  std::ranges::transform(times, moduli.begin(), [&](double time) { return series.at(time); });
  return moduli;
}

Eigen::VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

CommonTimesFit fit_of(const std::vector<PronySeries>& moduli, const TimeWindow& window) {
  constexpr int per_decade = 12;
  const auto times = sampled_times(window, per_decade);
  SampledModuli samples{as_vector(times), {}};
  for (const auto& one : moduli) samples.moduli.push_back(as_vector(moduli_at(one, times)));
  return CommonTimesFit(std::move(samples));
}

/// The relaxation times of the moduli themselves, and a dense list between them; rising [s].
Eigen::VectorXd candidate_times(const std::vector<PronySeries>& moduli, const TimeWindow& window) {
  constexpr int per_decade = 8;
  constexpr double same = 1e-3;  // relative distance below which two relaxation times count as one
  const TimeWindow wide = {window.begin / beyond_begin, window.end * beyond_end};
  auto times = sampled_times(wide, per_decade);
  for (const auto& one : moduli) {
    for (const auto& term : one.terms()) {
      if (term.relaxation_time > wide.begin && term.relaxation_time < wide.end) times.push_back(term.relaxation_time);
    }
  }
  std::ranges::sort(times);
  const auto are_same = [](double a, double b) { return b <= (1.0 + same) * a; };
  times.erase(std::unique(times.begin(), times.end(), are_same), times.end());
  return as_vector(times);
}

/// Lists of relaxation times, by their number: the times of the series, merged with the ratios of strength to modulus
/// as weights.
std::vector<Eigen::VectorXd> merged_times_of(const std::vector<PronySeries>& series,
                                             const std::vector<PronySeries>& moduli, const TimeWindow& window) {
  std::map<double, double> weights;
  for (std::size_t i = 0; i < series.size(); ++i) {
    for (const auto& [time, strength] : series[i].terms()) {
      weights[time] += strength / moduli[i].at(std::clamp(time, window.begin, window.end));
    }
  }
  std::vector<double> times, of_times;
  for (const auto& [time, weight] : weights) {
    times.push_back(time);
    of_times.push_back(weight);
  }
  return merged_times(as_vector(times), as_vector(of_times));
}

/// Relaxation times in the middle of equal parts of a window, on a logarithmic axis [s].
Eigen::VectorXd equidistant_times(const TimeWindow& window, Eigen::Index count) {
  const double ratio = window.end / window.begin;
  Eigen::VectorXd times(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    times[k] = window.begin * std::pow(ratio, (static_cast<double>(k) + 0.5) / static_cast<double>(count));
  }
  return times;
}

}  // namespace

std::vector<double> checked_times(const TimeWindow& window) {
  constexpr int per_decade = 40;
  return sampled_times(window, per_decade);
}

CommonTimesSearch::CommonTimesSearch(std::vector<PronySeries> moduli, const TimeWindow& window)
    : moduli_(std::move(moduli)),
      window_(window),
      checked_(checked_times(window)),
      fit_(fit_of(moduli_, window)),
      candidates_(candidate_times(moduli_, window)) {
  for (const auto& one : moduli_) checked_moduli_.push_back(moduli_at(one, checked_));
  dense_ = measured(fit_, candidates_);
  merged_ = merged_times_of(dense_.series, moduli_, window);
}

std::vector<Eigen::VectorXd> CommonTimesSearch::starts(Eigen::Index count) const {
  std::vector<Eigen::VectorXd> all;
  if (static_cast<std::size_t>(count) < merged_.size()) all.push_back(merged_[static_cast<std::size_t>(count)]);
  constexpr double wider = 3.0;
  all.push_back(equidistant_times(window_, count));
  all.push_back(equidistant_times({window_.begin / wider, window_.end * wider}, count));
  return all;
}

PronyReduction CommonTimesSearch::measured(const CommonTimesFit& fit, const Eigen::VectorXd& relaxation_times) const {
  PronyReduction found{fit.series(relaxation_times), {}};
  for (std::size_t i = 0; i < moduli_.size(); ++i) {
    found.deviations.push_back(largest_deviation(found.series[i], checked_, checked_moduli_[i]));
  }
  return found;
}

/// The series with the least largest deviation among those of Lawson's iteration, which begins with least squares and
/// multiplies the weights by the remaining deviations. `move` moves the relaxation times in each round.
PronyReduction CommonTimesSearch::evened(Eigen::VectorXd relaxation_times, const Mover& move) const {
  constexpr int rounds = 12;
  // Least weight over the largest one: a sample between two deviations of opposite sign keeps some weight.
  constexpr double floor = 0.1;
  auto fit = fit_;
  auto best = measured(fit, relaxation_times);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(fit.deviations_count());
  constexpr int most_in_vain = 3;
  int in_vain = 0;
  for (int round = 0; round <= rounds && in_vain < most_in_vain; ++round) {
    move(fit, relaxation_times, round);
    auto found = measured(fit, relaxation_times);
    constexpr double gain = 0.01;  // least relative gain
    in_vain = found.worst_deviation() < (1.0 - gain) * best.worst_deviation() ? 0 : in_vain + 1;
    if (found.worst_deviation() < best.worst_deviation()) best = std::move(found);
    const Eigen::VectorXd deviations = fit.deviations(relaxation_times, fit.strengths(relaxation_times)).cwiseAbs();
    const double largest = deviations.maxCoeff();
    if (!(largest > 0.0)) break;
    weights = weights.cwiseProduct((deviations / largest).cwiseMax(floor));
    weights /= weights.mean();
    fit.set_weights(weights);
  }
  return best;
}

PronyReduction CommonTimesSearch::nearest(double tolerance) const {
  if (dense_.worst_deviation() <= tolerance) return dense_;
  return evened(candidates_, [](const CommonTimesFit&, Eigen::VectorXd&, int) {});
}

PronyReduction CommonTimesSearch::moved(const Eigen::VectorXd& start) const {
  const double least = std::log(window_.begin / beyond_begin), most = std::log(window_.end * beyond_end);
  return evened(start, [&](const CommonTimesFit& fit, Eigen::VectorXd& relaxation_times, int round) {
    constexpr int evaluations = 40, evaluations_each = 6;
    Eigen::VectorXd logarithms = relaxation_times.array().log();
    fit.move(logarithms, least, most, round == 0 ? evaluations : evaluations_each);
    relaxation_times = logarithms.array().exp();
  });
}

PronyReduction CommonTimesSearch::with(std::size_t count) const {
  if (count == 0) return measured(fit_, Eigen::VectorXd());
  PronyReduction best;
  for (const auto& start : starts(static_cast<Eigen::Index>(count))) {
    auto found = moved(start);
    if (best.series.empty() || found.worst_deviation() < best.worst_deviation()) best = std::move(found);
  }
  return best;
}

}  // namespace breccia
