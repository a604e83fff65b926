// Example 2: from a measurement to a Prony series.
//
//   ex02_fit FILE.csv
//
// The file holds storage and loss moduli at several temperatures and frequencies, as a dynamic mechanical analysis
// gives them. They are shifted to one master curve at 19 degC, to which a Prony series and the law of Williams, Landel
// and Ferry are fitted. The data of data/synthetic_dma.csv are synthetic: a binder whose law has the constants 6.5 and
// 120 K, with a scatter of 1 %. So the fit can be compared with the truth.

#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "breccia/tables/measured_table_reader.hpp"
#include "breccia/viscoelasticity/master_curve.hpp"
#include "breccia/viscoelasticity/temperature_shift_fit.hpp"

namespace {

/// The rows of a table, which stand by temperature, as one sweep of frequencies for each temperature.
std::vector<breccia::FrequencySweep> sweeps_in(const breccia::MeasuredTable& table) {
  using breccia::Quantity;
  const auto& temperatures = table.column(Quantity::temperature).values;  // [K], whatever the unit of the file
  std::vector<breccia::FrequencySweep> sweeps;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool is_new = sweeps.empty() || std::abs(sweeps.back().temperature - temperatures[row]) > 0.1;
    if (is_new) sweeps.push_back({.temperature = temperatures[row]});
    sweeps.back().frequencies.push_back(table.column(Quantity::angular_frequency).values[row]);
    sweeps.back().storage.push_back(table.column(Quantity::storage_modulus).values[row]);
    sweeps.back().loss.push_back(table.column(Quantity::loss_modulus).values[row]);
  }
  return sweeps;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    fmt::print(stderr, "usage: ex02_fit FILE.csv\n");
    return 2;
  }
  constexpr double reference = 292.15;  // [K]
  const auto sweeps = sweeps_in(breccia::read_measured_table(arguments[1]));
  const auto master = breccia::master_curve(sweeps, reference);
  const auto law = breccia::fit_williams_landel_ferry(master.shift_factors, reference);
  if (!law) return 1;

  const auto& [series, quality] = master.fit;
  fmt::print("{} temperatures, {} reduced frequencies from {:.1e} to {:.1e} rad/s\n", sweeps.size(),
             master.frequencies.size(), master.frequencies.front(), master.frequencies.back());
  fmt::print("Prony series of {} terms; deviation from the data: median {:.1f} %, worst {:.1f} %\n",
             series.terms().size(), 100.0 * quality.median_error, 100.0 * quality.worst_error);
  for (const double t : {1e-9, 1e-6, 1e-3, 1.0}) fmt::print("  G({:.0e} s) = {:8.4f} MPa\n", t, series.at(t) / 1e6);
  fmt::print("Williams, Landel and Ferry: c1 = {:.2f} +- {:.2f}, c2 = {:.1f} +- {:.1f} K\n", law->law.c1, law->c1_error,
             law->law.c2, law->c2_error);

  const bool is_right = quality.median_error < 0.01 && std::abs(law->law.c1 - 6.5) < 3.0 * law->c1_error &&
                        std::abs(law->law.c2 - 120.0) < 3.0 * law->c2_error;
  fmt::print("The fit agrees with the truth within the scatter: {}\n", is_right ? "yes" : "no");
  return is_right ? 0 : 1;
}
