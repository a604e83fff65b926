#include "homogenisation/run/stage_extrapolation.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "homogenisation/run/isotropic_mean.hpp"
#include "homogenisation/run/named_errors.hpp"
#include "homogenisation/run/stage_tests.hpp"
#include "io/display.hpp"
#include "virtual_test/extrapolation.hpp"

namespace breccia {
namespace {

/// The tests that differ from the given one only in their grid, by rising number of cells.
std::vector<const TestResult*> same_on_all_grids(const TestResult& one, const std::vector<TestResult>& tests) {
  std::vector<const TestResult*> same;
  for (const auto& test : tests) {
    auto on_its_grid = one.id;
    on_its_grid.grid = test.id.grid;
    if (test.id == on_its_grid && !test.id.grid.is_extrapolated()) same.push_back(&test);
  }
  return same;
}

std::string pascals(double modulus) {
  return display(modulus, "Pa");
}

std::string per_pascal(double compliance) {
  return fmt::format("{:.3g} 1/Pa", compliance);
}

/// The limit of a value at a time [s] over several grids, with an error of first order in the cell side. `shown` writes
/// a value with its unit; `side` is the side of the box [m].
template <class Value>
Extrapolated limit(double side, const std::vector<const TestResult*>& grids, double time, const Value& value,
                   std::string (*shown)(double)) {
  std::vector<double> cell_sides, values;
  for (const auto* grid : grids) {
    cell_sides.push_back(side / grid->id.grid.cells().value());
    values.push_back(value(*grid));
  }
  const auto extrapolated = extrapolate(cell_sides, values);
  if (extrapolated.value > 0.0) return extrapolated;
  throw NumericalError(
      fmt::format("extrapolation to vanishing cells gives {} at {}: the grids are too "
                  "coarse for a law of first order; take finer ones",
                  shown(extrapolated.value), display_time(time)));
}

ExtrapolationRecord record_of(const std::vector<const TestResult*>& grids) {
  ExtrapolationRecord record;
  for (const auto* grid : grids) record.cells.push_back(grid->id.grid.cells().value());
  return record;
}

std::vector<double> moduli_of(const TestResult& test) {
  std::vector<double> moduli;
  for (const auto& sample : test.modulus) moduli.push_back(sample.modulus);
  return moduli;
}

double cells_of(const TestResult& test) {
  return test.id.grid.cells().value();
}

/// The largest errors up to each time [-], from the change from the next coarser grid to the finest one.
std::vector<double> errors_of(const std::vector<const TestResult*>& grids) {
  const auto &coarse = *grids[grids.size() - 2], &fine = *grids.back();
  return largest_errors(moduli_of(coarse), moduli_of(fine), cells_of(fine) / cells_of(coarse));
}

/// The largest errors up to each time of the shear tests beside another test [-]; empty without any.
std::vector<double> errors_of_shears(const TestResult& beside, const std::vector<TestResult>& tests) {
  std::vector<double> largest;
  for (const auto& shear : tests) {
    auto same = beside.id;
    same.load = shear.id.load;
    if (shear.id.load.is_bulk() || !(shear.id == same) || shear.modulus.size() != beside.modulus.size()) continue;
    const auto errors = errors_of(same_on_all_grids(shear, tests));
    largest.resize(errors.size(), 0.0);
    std::ranges::transform(errors, largest, largest.begin(),
                           [](double one, double other) { return std::max(one, other); });
  }
  return largest;
}

/// The relative half widths of the error band of a test at each time (theory, Eq. 43). A bulk modulus changes little
/// between two grids that are both wrong.
std::vector<double> half_widths_of(const TestResult& finest, const std::vector<const TestResult*>& grids,
                                   const std::vector<TestResult>& tests) {
  const bool is_bulk = finest.id.load.is_bulk();
  const auto own = errors_of(grids);
  const auto beside = is_bulk ? errors_of_shears(finest, tests) : std::vector<double>();
  const double factor = is_bulk && beside.empty() ? 4.0 : 2.0;
  std::vector<double> half_widths;
  for (std::size_t i = 0; i < own.size(); ++i) {
    half_widths.push_back(std::max(factor * own[i], beside.empty() ? 0.0 : beside[i]));
  }
  return half_widths;
}

/// The least relative half width of a band [-]. Between two grids of spheres with flow through gaps, the error of the
/// model does not show: 14 % was the largest that was measured (docs/gaps-in-space.md).
double least_half_width(Mixing mixing, int dimensions) {
  return mixing == Mixing::flow && dimensions == 3 ? 0.14 : 0.0;
}

/// Widens the band of the mean of shears to the widest relative band of these: in the mean the errors of some may
/// cancel those of others.
void widen_band(TestResult& mean, const std::vector<const TestResult*>& shears) {
  for (std::size_t i = 0; i < mean.half_bands.size(); ++i) {
    double widest = mean.half_bands[i] / mean.modulus[i].modulus;
    for (const auto* shear : shears) widest = std::max(widest, shear->half_bands[i] / shear->modulus[i].modulus);
    mean.half_bands[i] = widest * mean.modulus[i].modulus;
  }
}

/// The test on the finest grid, with its error band.
TestResult finest_with_band(const std::vector<const TestResult*>& grids, const std::vector<TestResult>& tests,
                            double least) {
  const auto& finest = *grids.back();
  TestResult result{
      .id = finest.id, .modulus = finest.modulus, .compliance = finest.compliance, .series = finest.series};
  result.id.grid = TestGrid::extrapolated();
  const auto half_widths = half_widths_of(finest, grids, tests);
  for (std::size_t i = 0; i < half_widths.size(); ++i) {
    result.half_bands.push_back(std::max(least, half_widths[i]) * finest.modulus[i].modulus);
  }
  result.record = record_of(grids);
  return result;
}

TestResult extrapolate_test(double side, const std::vector<const TestResult*>& grids) {
  const auto& finest = *grids.back();
  TestResult result{.id = finest.id};
  result.id.grid = TestGrid::extrapolated();
  for (std::size_t i = 0; i < finest.modulus.size(); ++i) {
    const double time = finest.modulus[i].time;
    const auto [modulus, half_band] = limit(
        side, grids, time, [i](const TestResult& grid) { return grid.modulus[i].modulus; }, pascals);
    result.modulus.push_back({time, modulus});
    result.half_bands.push_back(half_band);
    if (finest.compliance.empty()) continue;
    const auto creep = limit(
        side, grids, time, [i](const TestResult& grid) { return grid.compliance[i].compliance; }, per_pascal);
    result.compliance.push_back({time, creep.value});
  }
  result.series = fitted(result.modulus);
  result.record = record_of(grids);
  return result;
}

/// Whether the series of a test is exact, from a reduced response or a mean of several, instead of a fit to its curve.
bool has_exact_series(const TestResult& test, int dimensions, const std::vector<TestResult>& tests) {
  if (test.id.load.is_isotropic()) {
    return std::ranges::all_of(shears_beside(dimensions, test.id, tests),
                               [&](const TestResult* shear) { return has_exact_series(*shear, dimensions, tests); });
  }
  const auto* record = std::get_if<QuasistaticRecord>(&test.record);
  return record != nullptr && record->reduced.has_value();
}

}  // namespace

std::vector<TestResult> extrapolate_tests(const std::string& stage, double side, int dimensions,
                                          const std::vector<TestResult>& tests, Mixing mixing) {
  std::vector<TestResult> extrapolated;
  for (const auto& test : tests) {
    const auto grids = same_on_all_grids(test, tests);
    if (grids.size() < 2 || grids.back() != &test) continue;
    const auto name =
        fmt::format("{} {} {} {}", stage, name_of(test.id.load), name_of(test.id.boundary), name_of(test.id.method));
    extrapolated.push_back(name_errors(name, [&] {
      return has_mixed_cells(mixing) ? finest_with_band(grids, tests, least_half_width(mixing, dimensions))
                                     : extrapolate_test(side, grids);
    }));
    auto& latest = extrapolated.back();
    if (latest.id.load.is_isotropic()) widen_band(latest, shears_beside(dimensions, latest.id, extrapolated));
  }
  return extrapolated;
}

Curve curve_at(const TestResult& test, double side, int dimensions, const std::vector<TestResult>& tests, Mixing mixing,
               const std::vector<double>& times) {
  auto grids = test.id.grid.is_extrapolated() ? same_on_all_grids(test, tests) : std::vector{&test};
  if (has_mixed_cells(mixing)) grids.erase(grids.begin(), std::prev(grids.end()));
  const auto is_exact = [&](const TestResult* grid) { return has_exact_series(*grid, dimensions, tests); };
  if (!std::ranges::all_of(grids, is_exact)) return test.modulus;
  Curve curve;
  for (const double time : times) {
    const auto modulus = [time](const TestResult& grid) { return grid.series.at(time); };
    curve.push_back(
        {time, grids.size() == 1 ? modulus(*grids.front()) : limit(side, grids, time, modulus, pascals).value});
  }
  return curve;
}

}  // namespace breccia
