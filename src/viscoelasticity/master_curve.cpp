#include "breccia/viscoelasticity/master_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Core>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "viscoelasticity/least_squares.hpp"
#include "viscoelasticity/non_negative_least_squares.hpp"
#include "viscoelasticity/temperature_text.hpp"

namespace breccia {
namespace {

/// A modulus that rises with the frequency, as points of log10 frequency and log10 modulus.
struct RisingCurve {
  std::vector<double> frequency, modulus;

  explicit RisingCurve(const FrequencySweep& sweep) {
    for (std::size_t i = 0; i < sweep.frequencies.size(); ++i) {
      frequency.push_back(std::log10(sweep.frequencies[i]));
      // Scatter may make the measured modulus of a plateau fall, although a storage modulus always rises.
      const double value = std::log10(sweep.storage[i]);
      modulus.push_back(i == 0 ? value : std::max(value, modulus.back()));
    }
  }
};

/// A weighted mean.
struct WeightedSum {
  double sum = 0.0, weight = 0.0;
};

/// log10 of the factor by which the frequencies of `from` must be multiplied to match the moduli of `onto`, by least
/// squares of the differences of the modulus to first order, so that steep parts have the largest weight.
WeightedSum horizontal_distance(const RisingCurve& from, const RisingCurve& onto) {
  WeightedSum distance;
  for (std::size_t i = 0; i < from.modulus.size(); ++i) {
    const auto above = std::ranges::upper_bound(onto.modulus, from.modulus[i]);
    if (above == onto.modulus.begin() || above == onto.modulus.end()) continue;
    const auto j = static_cast<std::size_t>(above - onto.modulus.begin());
    const double rise = onto.modulus[j] - onto.modulus[j - 1];
    const double run = onto.frequency[j] - onto.frequency[j - 1];
    const double meets = onto.frequency[j - 1] + run * (from.modulus[i] - onto.modulus[j - 1]) / rise;
    const double weight = (rise / run) * (rise / run);
    distance.sum += weight * (meets - from.frequency[i]);
    distance.weight += weight;
  }
  return distance;
}

/// log10 a_T of each sweep relative to the first one, from the overlaps of neighbouring sweeps.
Eigen::VectorXd overlapping_shifts(const std::vector<FrequencySweep>& sweeps) {
  Eigen::VectorXd shifts = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(sweeps.size()));
  for (std::size_t i = 1; i < sweeps.size(); ++i) {
    const RisingCurve colder(sweeps[i - 1]), warmer(sweeps[i]);
    const auto there = horizontal_distance(warmer, colder);
    const auto back = horizontal_distance(colder, warmer);
    const double weight = there.weight + back.weight;
    if (!(weight > 0.0)) {
      constexpr double zero_celsius = 273.15;
      throw InputError(
          fmt::format("master curve: the storage moduli at {:.6g} and {:.6g} degC do not overlap, so that "
                      "nothing tells the shift between them; expected wider sweeps of frequency, or of "
                      "temperatures that are closer together, or data from one side of the gap alone",
                      sweeps[i - 1].temperature - zero_celsius, sweeps[i].temperature - zero_celsius));
    }
    const auto at = static_cast<Eigen::Index>(i);
    shifts[at] = shifts[at - 1] + (there.sum - back.sum) / weight;
  }
  return shifts;
}

/// Candidate relaxation times for all sweeps, a decade beyond their range after the initial shifts.
std::vector<double> relaxation_times(const std::vector<FrequencySweep>& sweeps, const Eigen::VectorXd& shifts,
                                     double per_decade) {
  constexpr double beyond = 1.0;
  double slowest = -HUGE_VAL, fastest = HUGE_VAL;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const double shift = shifts[static_cast<Eigen::Index>(i)];
    slowest = std::max(slowest, -shift - std::log10(sweeps[i].frequencies.front()) + beyond);
    fastest = std::min(fastest, -shift - std::log10(sweeps[i].frequencies.back()) - beyond);
  }
  const auto count = static_cast<int>(std::ceil(per_decade * (slowest - fastest))) + 1;
  std::vector<double> times(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    times[static_cast<std::size_t>(i)] = std::pow(10.0, fastest + (slowest - fastest) * i / (count - 1));
  }
  return times;
}

/// Storage and loss modulus of a Maxwell element of unit modulus at x = omega tau.
struct ComplexModulus {
  double storage, loss;
};
ComplexModulus maxwell_element(double x) {
  return {x * x / (1.0 + x * x), x / (1.0 + x * x)};
}
/// Derivatives of both moduli by log10 x.
ComplexModulus maxwell_element_slope(double x) {
  const double square = 1.0 + x * x, factor = std::numbers::ln10 * x / (square * square);
  return {2.0 * x * factor, (1.0 - x * x) * factor};
}

/// Relative deviations of the best spectrum from all sweeps, as a function of log10 a_T of all sweeps but the
/// reference.
class Projection {
 public:
  Projection(const std::vector<FrequencySweep>& sweeps, std::size_t reference, std::vector<double> times)
      : sweeps_(sweeps), reference_(reference), times_(std::move(times)) {
    for (const auto& sweep : sweeps) rows_ += 2 * static_cast<Eigen::Index>(sweep.frequencies.size());
  }

  /// Number of deviations.
  [[nodiscard]] Eigen::Index values() const { return rows_; }

  void set_deviations(const Eigen::VectorXd& shifts, Eigen::VectorXd& deviations) const {
    const auto columns = design_matrix(shifts);
    deviations = columns * best_spectrum(columns) - Eigen::VectorXd::Ones(rows_);
  }

  /// Jacobian by variable projection: the spectrum follows the shifts, so changes in the span of its used parts are
  /// projected out (Kaufman, BIT 15, 49, 1975).
  void set_jacobian(const Eigen::VectorXd& shifts, Eigen::MatrixXd& jacobian) const {
    const auto columns = design_matrix(shifts);
    const auto spectrum = best_spectrum(columns);
    const auto change = slopes(shifts, spectrum);
    jacobian.setZero(rows_, shifts.size());
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < sweeps_.size(); ++i) {
      const auto count = 2 * static_cast<Eigen::Index>(sweeps_[i].frequencies.size());
      if (i != reference_) jacobian.col(unknown(i)).segment(row, count) = change.segment(row, count);
      row += count;
    }
    const auto basis = used_part(columns, spectrum);
    jacobian -= basis * (basis.transpose() * jacobian);
  }

  /// Number of used (non-zero) parts of the spectrum.
  [[nodiscard]] Eigen::Index used_terms(const Eigen::VectorXd& shifts) const {
    return (best_spectrum(design_matrix(shifts)).array() > 0.0).count();
  }

  /// Index of a sweep other than the reference among the unknowns.
  [[nodiscard]] Eigen::Index unknown(std::size_t sweep) const {
    return static_cast<Eigen::Index>(sweep < reference_ ? sweep : sweep - 1);
  }

 private:
  [[nodiscard]] double shift_factor(const Eigen::VectorXd& shifts, std::size_t sweep) const {
    return sweep == reference_ ? 1.0 : std::pow(10.0, shifts[unknown(sweep)]);
  }

  /// Responses relative to the data: one column for each relaxation time and one for the equilibrium modulus; rows with
  /// the storage and loss modulus in turn.
  [[nodiscard]] Eigen::MatrixXd design_matrix(const Eigen::VectorXd& shifts) const {
    const auto terms = static_cast<Eigen::Index>(times_.size());
    Eigen::MatrixXd columns(rows_, terms + 1);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < sweeps_.size(); ++i) {
      const auto& sweep = sweeps_[i];
      for (std::size_t j = 0; j < sweep.frequencies.size(); ++j, row += 2) {
        const double frequency = shift_factor(shifts, i) * sweep.frequencies[j];
        for (Eigen::Index k = 0; k < terms; ++k) {
          const auto [storage, loss] = maxwell_element(frequency * times_[static_cast<std::size_t>(k)]);
          columns(row, k) = storage / sweep.storage[j];
          columns(row + 1, k) = loss / sweep.loss[j];
        }
        columns(row, terms) = 1.0 / sweep.storage[j];
        columns(row + 1, terms) = 0.0;
      }
    }
    return columns;
  }

  /// Derivatives of the response of a spectrum by log10 a_T of the sweep of each row.
  [[nodiscard]] Eigen::VectorXd slopes(const Eigen::VectorXd& shifts, const Eigen::VectorXd& spectrum) const {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(rows_);
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < sweeps_.size(); ++i) {
      const auto& sweep = sweeps_[i];
      for (std::size_t j = 0; j < sweep.frequencies.size(); ++j, row += 2) {
        const double frequency = shift_factor(shifts, i) * sweep.frequencies[j];
        for (std::size_t k = 0; k < times_.size(); ++k) {
          const double strength = spectrum[static_cast<Eigen::Index>(k)];
          const auto [storage, loss] = maxwell_element_slope(frequency * times_[k]);
          change[row] += strength * storage / sweep.storage[j];
          change[row + 1] += strength * loss / sweep.loss[j];
        }
      }
    }
    return change;
  }

  [[nodiscard]] Eigen::VectorXd best_spectrum(const Eigen::MatrixXd& columns) const {
    return non_negative_least_squares(columns, Eigen::VectorXd::Ones(rows_));
  }

  /// An orthonormal basis of the used columns.
  [[nodiscard]] static Eigen::MatrixXd used_part(const Eigen::MatrixXd& columns, const Eigen::VectorXd& spectrum) {
    std::vector<Eigen::Index> used;
    for (Eigen::Index k = 0; k < spectrum.size(); ++k) {
      if (spectrum[k] > 0.0) used.push_back(k);
    }
    return orthonormal_basis(columns(Eigen::all, used));
  }

  const std::vector<FrequencySweep>& sweeps_;
  std::size_t reference_;
  std::vector<double> times_;
  Eigen::Index rows_ = 0;
};

void require_sweeps(const std::vector<FrequencySweep>& sweeps) {
  if (sweeps.size() < 2) throw InputError("master curve: expected sweeps at two temperatures at least");
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const auto& [temperature, frequencies, storage, loss] = sweeps[i];
    if (!(temperature > 0.0) || !std::isfinite(temperature)) {
      throw InputError(fmt::format("master curve: expected a positive temperature, got {} K", temperature));
    }
    if (i > 0 && temperature == sweeps[i - 1].temperature) {
      throw InputError(fmt::format("master curve: two sweeps at {}", in_kelvin_and_celsius(temperature)));
    }
    constexpr std::size_t fewest = 2;
    if (frequencies.size() < fewest || storage.size() != frequencies.size() || loss.size() != frequencies.size()) {
      throw InputError(
          fmt::format("master curve: the sweep at {} has {} frequencies, {} storage and {} loss "
                      "moduli; expected at least {} and as many of each",
                      in_kelvin_and_celsius(temperature), frequencies.size(), storage.size(), loss.size(), fewest));
    }
    const auto is_positive = [](double x) { return x > 0.0 && std::isfinite(x); };
    if (!std::ranges::all_of(frequencies, is_positive) || !std::ranges::all_of(storage, is_positive) ||
        !std::ranges::all_of(loss, is_positive)) {
      throw InputError(fmt::format("master curve: the sweep at {}: expected positive frequencies and moduli",
                                   in_kelvin_and_celsius(temperature)));
    }
    if (!std::ranges::is_sorted(frequencies, std::ranges::less_equal{})) {
      throw InputError(fmt::format("master curve: the sweep at {}: expected rising frequencies",
                                   in_kelvin_and_celsius(temperature)));
    }
  }
}

std::size_t reference_sweep(const std::vector<FrequencySweep>& sweeps, double reference_temperature) {
  constexpr double close = 0.01;
  const auto found = std::ranges::find_if(sweeps, [&](const FrequencySweep& sweep) {
    return std::abs(sweep.temperature - reference_temperature) <= close;
  });
  if (found != sweeps.end()) return static_cast<std::size_t>(found - sweeps.begin());
  std::vector<std::string> temperatures;
  temperatures.reserve(sweeps.size());
  for (const auto& sweep : sweeps) temperatures.push_back(in_kelvin_and_celsius(sweep.temperature));
  throw InputError(fmt::format("master curve: no sweep at the reference temperature {}; there are {}",
                               in_kelvin_and_celsius(reference_temperature), fmt::join(temperatures, ", ")));
}

/// log10 a_T of all sweeps but the reference, and their standard errors.
struct Shifts {
  Eigen::VectorXd values, standard_errors;
};

Shifts best_shifts(const Projection& projection, const Eigen::VectorXd& start) {
  Shifts shifts = {start, {}};
  const NonlinearLeastSquares problem = {
      .values = projection.values(),
      .deviations = [&](const auto& x, auto& deviations) { projection.set_deviations(x, deviations); },
      .jacobian = [&](const auto& x, auto& jacobian) { projection.set_jacobian(x, jacobian); }};
  // Tolerance far below the standard errors.
  const SearchLimits limits = {.relative_step = 1e-6, .relative_decrease = 1e-8, .most_evaluations = 200};
  if (!search_least_squares(problem, limits, shifts.values) || !shifts.values.allFinite()) {
    throw NumericalError("master curve: the shift factors do not converge");
  }
  Eigen::VectorXd deviations(projection.values());
  Eigen::MatrixXd jacobian(projection.values(), start.size());
  projection.set_deviations(shifts.values, deviations);
  projection.set_jacobian(shifts.values, jacobian);
  const auto freedom = projection.values() - projection.used_terms(shifts.values) - start.size();
  const double variance = deviations.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, freedom));
  const auto unit_variances = variances(jacobian);
  if (!unit_variances) {
    throw NumericalError(
        "master curve: the data do not determine the shift of every sweep; leave out temperatures whose sweeps are "
        "flat");
  }
  shifts.standard_errors = (variance * *unit_variances).cwiseSqrt();
  return shifts;
}

/// The data of all sweeps at their reduced frequencies, in rising order.
void merge(const std::vector<FrequencySweep>& sweeps, MasterCurve& curve) {
  struct Datum {
    double frequency, storage, loss;
  };
  std::vector<Datum> data;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const double factor = std::pow(10.0, curve.shift_factors[i].log10_factor);
    for (std::size_t j = 0; j < sweeps[i].frequencies.size(); ++j) {
      data.push_back({factor * sweeps[i].frequencies[j], sweeps[i].storage[j], sweeps[i].loss[j]});
    }
  }
  std::ranges::stable_sort(data, {}, &Datum::frequency);
  for (const auto& [frequency, storage, loss] : data) {
    curve.frequencies.push_back(frequency);
    curve.storage.push_back(storage);
    curve.loss.push_back(loss);
  }
}

}  // namespace

MasterCurve master_curve(std::vector<FrequencySweep> sweeps, double reference_temperature, const FitOptions& options) {
  std::ranges::sort(sweeps, {}, &FrequencySweep::temperature);
  require_sweeps(sweeps);
  const auto reference = reference_sweep(sweeps, reference_temperature);

  Eigen::VectorXd start = overlapping_shifts(sweeps);
  start.array() -= start[static_cast<Eigen::Index>(reference)];
  const Projection projection(sweeps, reference, relaxation_times(sweeps, start, options.times_per_decade));
  Eigen::VectorXd others(start.size() - 1);
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    if (i != reference) others[projection.unknown(i)] = start[static_cast<Eigen::Index>(i)];
  }
  const auto shifts = best_shifts(projection, others);

  MasterCurve curve = {.reference_temperature = sweeps[reference].temperature};
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    ShiftFactor factor = {sweeps[i].temperature, 0.0};
    if (i != reference) {
      factor.log10_factor = shifts.values[projection.unknown(i)];
      factor.standard_error = shifts.standard_errors[projection.unknown(i)];
    }
    curve.shift_factors.push_back(factor);
  }
  merge(sweeps, curve);
  curve.fit = fit_dynamic(curve.frequencies, curve.storage, curve.loss, options);
  return curve;
}

}  // namespace breccia
