#include "cli/comparison_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "breccia/tables/modulus_kind.hpp"

#include "io/display.hpp"

namespace breccia::cli {
namespace {

/// Words on the modulus that is compared: its kind, unless it is the shear modulus, and the shear, where a stage has
/// several and no mean of them.
std::string words_on_modulus(const StageResult& stage, const Comparison& compared) {
  const auto kind = compared.kind == ModulusKind::shear ? "" : fmt::format(", {},", name(compared.kind));
  const bool is_one = compared.test.load == Load::shear && std::ranges::any_of(stage.tests, [](const TestResult& test) {
                        return !test.id.load.is_bulk() && test.id.load != Load::shear;
                      });
  return kind + (is_one ? " in shear xy, one of several shears," : "");
}

/// Words on the errors of the computed moduli of samples.
template <class Sample>
std::string words_on_errors(const std::vector<Sample>& samples) {
  double largest = 0.0;
  std::size_t known = 0;
  for (const auto& sample : samples) {
    if (!sample.error) continue;
    ++known;
    largest = std::max(largest, *sample.error);
  }
  if (known == 0) return "error of the computed modulus unknown";
  return fmt::format("error of the computed modulus up to {:.2g} %{}", 100.0 * largest,
                     known < samples.size() ? ", not known everywhere" : "");
}

/// A table of the ratios of all computed moduli to one measurement, at whole decades; empty without samples in time.
std::string table_in_time(const std::string& measurement, const StageResult& stage) {
  std::vector<const Comparison*> compared;
  TimeWindow times = {std::numeric_limits<double>::infinity(), 0.0};
  for (const auto& comparison : stage.comparisons) {
    if (comparison.measurement != measurement || comparison.samples.empty()) continue;
    compared.push_back(&comparison);
    times.begin = std::min(times.begin, comparison.samples.front().time);
    times.end = std::max(times.end, comparison.samples.back().time);
  }
  if (compared.empty()) return {};
  auto text = fmt::format("\n{}{} over what was measured, {}\n{:>12}", stage.name,
                          words_on_modulus(stage, *compared.front()), measurement, "");
  for (const auto* comparison : compared) text += fmt::format("  {:>12}", name_of(comparison->test.boundary));
  text += fmt::format("\n{:>12}", "time");
  for (const auto* comparison : compared) text += fmt::format("  {:>12}", name_of(comparison->test.method));
  text += fmt::format("  {:>12}", "measured");
  for (const double t : logarithmic_times(times, 1)) {
    text += fmt::format("\n{:>12}", display_time(t));
    double measured = 0.0;
    for (const auto* comparison : compared) {
      const auto at = std::ranges::find_if(
          comparison->samples, [t](const ComparedSample& sample) { return std::abs(sample.time / t - 1.0) < 1e-6; });
      const bool is_known = at != comparison->samples.end();
      if (is_known) measured = at->measured;
      text += fmt::format("  {:>12}", is_known ? fmt::format("{:.3f}", at->ratio()) : "");
    }
    if (measured > 0.0) text += fmt::format("  {:>12}", display(measured, "Pa"));
  }
  for (const auto* comparison : compared) {
    const auto &best = *comparison->best(), &worst = *comparison->worst();
    text +=
        fmt::format("\n  {}, {}: nearest {:.3f} at {}, furthest {:.3f} at {}; {}", name_of(comparison->test.boundary),
                    name_of(comparison->test.method), best.ratio(), display_time(best.time), worst.ratio(),
                    display_time(worst.time), words_on_errors(comparison->samples));
  }
  return text + "\n";
}

std::string hertz(double angular_frequency) {
  return display(angular_frequency / (2.0 * std::numbers::pi), "Hz");
}

/// A table of the ratios of a computed complex modulus to a measured one; of many frequencies every second, third, ...
std::string table_in_frequency(const StageResult& stage, const Comparison& comparison) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  const auto& samples = comparison.in_frequency;
  const auto letter = symbol(comparison.kind);
  auto text = fmt::format(
      "\n{}, {}, {}, over what was measured, {}\n{:>12}  {:>7}  {:>10}  {:>7}  {:>7}  {:>9}  {:>13}  {:>9}", stage.name,
      name_of(comparison.test.boundary), name_of(comparison.test.method), comparison.measurement, "frequency",
      fmt::format("|{}*|", letter), "phase", fmt::format("{}'", letter), fmt::format("{}''", letter), "tan delta",
      fmt::format("measured |{}*|", letter), "phase");
  constexpr std::size_t most_rows = 12;
  const std::size_t step = (samples.size() + most_rows - 1) / most_rows;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    const auto& one = samples[i];
    const double storage = one.storage / one.measured_storage, loss = one.loss / one.measured_loss;
    text += fmt::format("\n{:>12}  {:>7.3f}  {:>10}  {:>7.3f}  {:>7.3f}  {:>9.3f}  {:>13}  {:>9}",
                        hertz(one.angular_frequency), one.ratio(),
                        fmt::format("{:+.2f} deg", degrees * one.phase_difference()), storage, loss, loss / storage,
                        display(std::hypot(one.measured_storage, one.measured_loss), "Pa"),
                        fmt::format("{:.3g} deg", degrees * std::atan2(one.measured_loss, one.measured_storage)));
  }
  const auto &best = *comparison.best_in_frequency(), &worst = *comparison.worst_in_frequency();
  return text + fmt::format("\n  |{}*|: nearest {:.3f} at {}, furthest {:.3f} at {}; {}\n", letter, best.ratio(),
                            hertz(best.angular_frequency), worst.ratio(), hertz(worst.angular_frequency),
                            words_on_errors(samples));
}

std::string table_of(const std::string& measurement, const StageResult& stage, Abscissa abscissa) {
  std::string text;
  for (const auto& comparison : stage.comparisons) {
    const bool is_shown = comparison.measurement == measurement && !comparison.in_frequency.empty();
    if (is_shown && abscissa == Abscissa::frequency) text += table_in_frequency(stage, comparison);
  }
  return text.empty() ? table_in_time(measurement, stage) : text;
}

}  // namespace

std::string comparison_tables_of(const std::vector<StageResult>& stages, Abscissa abscissa) {
  std::string text;
  for (const auto& stage : stages) {
    std::vector<std::string> shown;
    for (const auto& comparison : stage.comparisons) {
      if (std::ranges::find(shown, comparison.measurement) != shown.end()) continue;
      shown.push_back(comparison.measurement);
      text += table_of(comparison.measurement, stage, abscissa);
    }
  }
  return text;
}

}  // namespace breccia::cli
