#include "cli/frequency_tables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "breccia/results/frequency_rows.hpp"

#include "cli/shown_tests.hpp"
#include "homogenisation/complex_moduli.hpp"
#include "io/display.hpp"
#include "results/engineering_curves.hpp"

namespace breccia::cli {
namespace {

constexpr FrequencyRows decades_of_hertz{.hertz_per_decade = 1};

/// The two lines above a table of the modulus of this symbol: "G".
std::string head_of_table(const std::string& title, const std::string& symbol, bool has_errors) {
  return fmt::format("\n{}\n{:>12}  {:>12}{}  {:>9}  {:>12}  {:>12}  {:>9}\n", title, "frequency", "|" + symbol + "*|",
                     has_errors ? "     error" : "", "phase", symbol + "'", symbol + "''", "tan delta");
}

/// A row; `error` is the column of the error, or empty.
std::string row_of(const ComplexSample& sample, const std::string& error) {
  constexpr double per_cycle = 2.0 * std::numbers::pi, degrees = 180.0 / std::numbers::pi;
  const auto& [omega, storage, loss, share] = sample;
  return fmt::format("{:>12}  {:>12}{}  {:>9}  {:>12}  {:>12}  {:>9.3g}", display(omega / per_cycle, "Hz"),
                     display(std::hypot(storage, loss), "Pa"), error,
                     fmt::format("{:.3g} deg", degrees * std::atan2(loss, storage)), display(storage, "Pa"),
                     display(loss, "Pa"), loss / storage);
}

std::string table_of(const StageResult& stage, const TestResult& test) {
  const auto name = modulus_in_words(test.id.load, stage.dimensions);
  const bool has_errors = has_known_error(test);
  auto text =
      head_of_table(fmt::format("{}, {}, {}, {}", stage.name, name, name_of(test.id.boundary), name_of(test.id.method)),
                    test.id.load.is_bulk() ? "M" : "G", has_errors);
  for (const auto& sample : complex_moduli(test, decades_of_hertz.of(test.modulus))) {
    text += row_of(sample, has_errors ? fmt::format("  {:>8}", error_text(sample.error)) : "") + '\n';
  }
  return text;
}

/// Young's modulus, with Poisson's ratio.
std::string table_of(const StageResult& stage, const EngineeringCurves& curves) {
  const bool has_errors =
      std::ranges::any_of(curves.in_frequency, [](const auto& sample) { return sample.errors.young.has_value(); });
  auto text = head_of_table(fmt::format("{}, E, {}, {}; nu is the real part of Poisson's ratio", stage.name,
                                        name_of(curves.test.boundary), name_of(curves.test.method)),
                            "E", has_errors);
  text.insert(text.size() - 1, fmt::format("  {:>8}", "nu"));
  for (const auto& sample : curves.in_frequency) {
    const auto error = has_errors ? fmt::format("  {:>8}", error_text(sample.errors.young)) : "";
    text += row_of({sample.angular_frequency, sample.young.real(), sample.young.imag()}, error) +
            fmt::format("  {:>8.4f}\n", sample.poisson.real());
  }
  return text;
}

}  // namespace

std::string frequency_table_of(const StageResult& stage) {
  std::string text;
  for (const auto* test : shown_tests(stage)) {
    if (test->series.unrelaxed() > 0.0) text += table_of(stage, *test);
  }
  for (const auto& curves : engineering_curves(stage, decades_of_hertz)) text += table_of(stage, curves);
  return text;
}

}  // namespace breccia::cli
