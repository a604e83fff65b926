#include "deck/observations.hpp"

#include <cstddef>
#include <optional>
#include <variant>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deck/fit_data.hpp"

namespace breccia {
namespace {

ObservedModulus observed(ModulusKind kind) {
  if (kind == ModulusKind::young) return ObservedModulus::young;
  return kind == ModulusKind::bulk ? ObservedModulus::bulk : ObservedModulus::shear;
}

/// Makes observations of data of each kind.
struct ObservationsOf {
  const MeasuredTable& table;
  ObservedModulus modulus;

  std::vector<Observation> operator()(const RelaxationData& data) const {
    return over_time(ObservedCurve::relaxation, data.times, data.moduli);
  }
  std::vector<Observation> operator()(const CreepData& data) const {
    return over_time(ObservedCurve::creep, data.times, data.compliances);
  }
  std::vector<Observation> operator()(const DynamicData& data) const {
    if (data.is_of_ramp) {
      throw InputError(fmt::format(
          "{}: the temperature changes through the measurement, so that moduli at one temperature are interpolated and "
          "depend on each other; expected sweeps over frequency at steady temperatures",
          table.path().string()));
    }
    const bool has_temperatures = table.has({Quantity::temperature});
    std::vector<Observation> observations;
    for (const auto& sweep : data.sweeps) {
      const auto temperature = has_temperatures ? std::optional(sweep.temperature) : std::nullopt;
      for (std::size_t i = 0; i < sweep.frequencies.size(); ++i) {
        const auto add = [&](ObservedCurve curve, double value) {
          observations.push_back({.modulus = modulus,
                                  .curve = curve,
                                  .at = sweep.frequencies[i],
                                  .temperature = temperature,
                                  .value = value});
        };
        add(ObservedCurve::storage, sweep.storage[i]);
        add(ObservedCurve::loss, sweep.loss[i]);
      }
    }
    return observations;
  }
  std::vector<Observation> operator()(const PronySeries& /*fit*/) const {
    throw InputError(fmt::format("{}: a Prony series is a fit; expected measured values over time or frequency",
                                 table.path().string()));
  }

 private:
  [[nodiscard]] std::vector<Observation> over_time(ObservedCurve curve, const std::vector<double>& times,
                                                   const std::vector<double>& values) const {
    if (table.has({Quantity::temperature})) {
      throw InputError(fmt::format(
          "{}: a column of temperatures beside a curve over time is not used: the curve is taken at the temperature of "
          "the run; leave out the column, or shift the times",
          table.path().string()));
    }
    std::vector<Observation> observations;
    for (std::size_t i = 0; i < times.size(); ++i) {
      observations.push_back({.modulus = modulus, .curve = curve, .at = times[i], .value = values[i]});
    }
    return observations;
  }
};

}  // namespace

ReadObservations observations_in(const MeasuredTable& table, ModulusKind given) {
  const auto [data, kind] = measured_data_in(table, given);
  return {std::visit(ObservationsOf{table, observed(kind)}, data), kind};
}

}  // namespace breccia
