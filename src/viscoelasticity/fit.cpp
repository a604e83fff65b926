#include "breccia/viscoelasticity/fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "viscoelasticity/fit_quality.hpp"
#include "viscoelasticity/fitted_data.hpp"
#include "viscoelasticity/non_negative_least_squares.hpp"

namespace breccia {
namespace {

/// The decay exp(-t / tau) after a step at time 0; after a ramp of duration T, its mean over the instants of the ramp
/// (theory, Eq. 26).
double decay(double t, double tau, double ramp) {
  if (ramp == 0.0) return std::exp(-t / tau);
  if (t <= ramp) return -std::expm1(-t / tau) * tau / ramp;
  return std::exp(-(t - ramp) / tau) * -std::expm1(-ramp / tau) * tau / ramp;
}

/// Finished share of the ramp, and the mean time since the load was applied, averaged over the ramp so far.
double applied(double t, double ramp) {
  return t < ramp ? t / ramp : 1.0;
}
double time_since(double t, double ramp) {
  return t < ramp ? 0.5 * t * t / ramp : t - 0.5 * ramp;
}

/// Candidate relaxation or retardation times of a fit: logarithmic, and somewhat beyond the range of the data.
std::vector<double> characteristic_times(double first, double last, double per_decade) {
  constexpr double beyond = 3.0;
  const double from = first / beyond, to = last * beyond;
  const auto count = std::max(2, static_cast<int>(std::ceil(per_decade * std::log10(to / from))) + 1);
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) times.push_back(from * std::pow(to / from, static_cast<double>(i) / (count - 1)));
  return times;
}

struct Fit {
  Eigen::VectorXd amplitudes;
  FitQuality quality;
};

/// Fits a spectrum. Each column has the responses of one part of the spectrum at the data points. `at` has the time or
/// frequency of each datum, repeated if data have several values.
Fit fit(const Eigen::MatrixXd& columns, const Eigen::VectorXd& data, const std::vector<double>& at) {
  const Eigen::MatrixXd relative = data.cwiseInverse().asDiagonal() * columns;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(data.size());
  Fit result;
  result.amplitudes = non_negative_least_squares(relative, ones);
  const Eigen::VectorXd deviations = relative * result.amplitudes - ones;
  std::vector<Eigen::Index> used;
  for (Eigen::Index j = 0; j < result.amplitudes.size(); ++j) {
    if (result.amplitudes[j] > 0.0) used.push_back(j);
  }
  result.quality = quality_of_fit(data, deviations, at, relative(Eigen::all, used));
  return result;
}

std::vector<MaxwellTerm> maxwell_terms(const std::vector<double>& times, const Eigen::VectorXd& amplitudes) {
  std::vector<MaxwellTerm> terms;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (const double strength = amplitudes[static_cast<Eigen::Index>(k)]; strength > 0.0) {
      terms.push_back({times[k], strength});
    }
  }
  return terms;
}

}  // namespace

RelaxationFit fit_relaxation(std::span<const double> times, std::span<const double> moduli, const FitOptions& options) {
  require_fitted_data(times, {moduli}, "relaxation data");
  const auto spectrum = characteristic_times(times.front(), times.back(), options.times_per_decade);
  const auto count = static_cast<Eigen::Index>(spectrum.size());
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(times.size()), count + 1);
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const double t = times[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < count; ++k) {
      columns(i, k) = decay(t, spectrum[static_cast<std::size_t>(k)], options.ramp);
    }
    columns(i, count) = applied(t, options.ramp);
  }
  const Eigen::Map<const Eigen::VectorXd> data(moduli.data(), columns.rows());
  auto [amplitudes, quality] = fit(columns, data, {times.begin(), times.end()});
  return {PronySeries(amplitudes[count], maxwell_terms(spectrum, amplitudes)), std::move(quality)};
}

CreepFit fit_creep(std::span<const double> times, std::span<const double> compliances, const FitOptions& options) {
  require_fitted_data(times, {compliances}, "creep data");
  const auto spectrum = characteristic_times(times.front(), times.back(), options.times_per_decade);
  const auto count = static_cast<Eigen::Index>(spectrum.size());
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(times.size()), count + 2);
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    const double t = times[static_cast<std::size_t>(i)];
    const double stress = applied(t, options.ramp);
    for (Eigen::Index k = 0; k < count; ++k) {
      columns(i, k) = stress - decay(t, spectrum[static_cast<std::size_t>(k)], options.ramp);
    }
    columns(i, count) = stress;
    columns(i, count + 1) = time_since(t, options.ramp);
  }
  const Eigen::Map<const Eigen::VectorXd> data(compliances.data(), columns.rows());
  auto [amplitudes, quality] = fit(columns, data, {times.begin(), times.end()});
  std::vector<RetardationTerm> terms;
  for (Eigen::Index k = 0; k < count; ++k) {
    if (amplitudes[k] > 0.0) terms.push_back({spectrum[static_cast<std::size_t>(k)], amplitudes[k]});
  }
  // Data without an instantaneous jump do not determine the unrelaxed modulus: any very large value fits them.
  constexpr double small = 1e-6;
  const double instantaneous = std::max(amplitudes[count], small * compliances.front());
  return {CreepCompliance(instantaneous, std::move(terms), amplitudes[count + 1]), std::move(quality)};
}

RelaxationFit fit_dynamic(std::span<const double> frequencies, std::span<const double> storage,
                          std::span<const double> loss, const FitOptions& options) {
  require_fitted_data(frequencies, {storage, loss}, "dynamic data");
  const auto spectrum =
      characteristic_times(1.0 / frequencies.back(), 1.0 / frequencies.front(), options.times_per_decade);
  const auto terms = static_cast<Eigen::Index>(spectrum.size());
  const auto count = static_cast<Eigen::Index>(frequencies.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(2 * count, terms + 1);
  Eigen::VectorXd data(2 * count);
  std::vector<double> at(frequencies.begin(), frequencies.end());
  at.insert(at.end(), frequencies.begin(), frequencies.end());
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < terms; ++k) {
      const double x = frequencies[static_cast<std::size_t>(i)] * spectrum[static_cast<std::size_t>(k)];
      columns(i, k) = x * x / (1.0 + x * x);
      columns(count + i, k) = x / (1.0 + x * x);
    }
    columns(i, terms) = 1.0;
    data[i] = storage[static_cast<std::size_t>(i)];
    data[count + i] = loss[static_cast<std::size_t>(i)];
  }
  auto [amplitudes, quality] = fit(columns, data, at);
  return {PronySeries(amplitudes[terms], maxwell_terms(spectrum, amplitudes)), std::move(quality)};
}

}  // namespace breccia
