#include "deck/fitted_modulus.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"
#include "breccia/viscoelasticity/fit.hpp"
#include "breccia/viscoelasticity/interconversion.hpp"
#include "breccia/viscoelasticity/master_curve.hpp"
#include "breccia/viscoelasticity/temperature_shift_fit.hpp"

#include "deck/fit_data.hpp"

namespace breccia {
namespace {

std::vector<MeasuredModulus> measured_moduli(const std::vector<double>& frequencies, const std::vector<double>& storage,
                                             const std::vector<double>& loss) {
  std::vector<MeasuredModulus> moduli;
  for (std::size_t i = 0; i < frequencies.size(); ++i) moduli.push_back({frequencies[i], storage[i], loss[i]});
  return moduli;
}

struct FitModulus {
  std::optional<double> reference_temperature;

  FittedModulus operator()(const RelaxationData& data) const {
    refuse_temperature();
    auto fit = fit_relaxation(data.times, data.moduli);
    return {.series = std::move(fit.series),
            .measured_times = TimeWindow{data.times.front(), data.times.back()},
            .median_error = fit.quality.median_error};
  }
  FittedModulus operator()(const CreepData& data) const {
    refuse_temperature();
    const auto fit = fit_creep(data.times, data.compliances);
    return {.series = relaxation_modulus(fit.compliance),
            .measured_times = TimeWindow{data.times.front(), data.times.back()},
            .median_error = fit.quality.median_error};
  }
  FittedModulus operator()(const DynamicData& data) const {
    if (data.sweeps.size() > 1) {
      auto curve = master_curve(data.sweeps, temperature_among(data.sweeps));
      auto law = shift_law_of(curve);
      return {.series = std::move(curve.fit.series),
              .measured_times = times_of(curve.frequencies),
              .shift_law = std::move(law),
              .dynamic = measured_moduli(curve.frequencies, curve.storage, curve.loss),
              .median_error = curve.fit.quality.median_error};
    }
    refuse_temperature();
    const auto& sweep = data.sweeps.front();
    auto fit = fit_dynamic(sweep.frequencies, sweep.storage, sweep.loss);
    return {.series = std::move(fit.series),
            .measured_times = times_of(sweep.frequencies),
            .dynamic = measured_moduli(sweep.frequencies, sweep.storage, sweep.loss),
            .median_error = fit.quality.median_error};
  }
  FittedModulus operator()(const PronySeries& series) const {
    refuse_temperature();
    return {.series = series, .measured_times = std::nullopt};
  }

 private:
  [[nodiscard]] static TimeWindow times_of(const std::vector<double>& rising_frequencies) {
    return {1.0 / rising_frequencies.back(), 1.0 / rising_frequencies.front()};
  }
  void refuse_temperature() const {
    if (reference_temperature) {
      throw InputError("reference_temperature: only for dynamic moduli at several temperatures");
    }
  }
  [[nodiscard]] double temperature_among(const std::vector<FrequencySweep>& sweeps) const {
    constexpr double close = 0.5, zero_celsius = 273.15;
    std::vector<std::string> known;
    for (const auto& sweep : sweeps) {
      if (reference_temperature && std::abs(sweep.temperature - *reference_temperature) <= close) {
        return sweep.temperature;
      }
      known.push_back(fmt::format("{:.4g} degC", sweep.temperature - zero_celsius));
    }
    throw InputError(fmt::format("several temperatures: expected the reference_temperature of one of the sweeps, at {}",
                                 fmt::join(known, ", ")));
  }
};

}  // namespace

std::vector<std::string> remarks_on(const FittedModulus& fitted, const std::filesystem::path& file, ModulusKind kind) {
  const auto name = file.filename().string();
  std::vector<std::string> remarks;
  if (!fitted.names_kind) {
    remarks.push_back(fmt::format(
        "{} does not say which modulus it has: it is taken for {}; names of columns that begin with \"{}\" say it",
        name, symbol(kind), column_prefix(kind)));
  }
  constexpr double much = 0.1;
  if (fitted.median_error >= much) {
    remarks.push_back(fmt::format(
        "the fit misses the data of {} by {:.0f} % in the median: they scatter by as much, or are not those "
        "of a linear viscoelastic solid (`breccia fit` shows them)",
        name, 100.0 * fitted.median_error));
  }
  return remarks;
}

FittedModulus fitted_modulus(const std::filesystem::path& file, ModulusKind kind,
                             std::optional<double> reference_temperature) {
  const auto table = read_measured_table(file);
  auto fitted = std::visit(FitModulus{reference_temperature}, fit_data_in(table, kind).data);
  fitted.names_kind = std::ranges::any_of(table.kinds(), [kind](ModulusKind one) { return one == kind; });
  return fitted;
}

}  // namespace breccia
