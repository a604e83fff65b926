#include "cli/shown_tests.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "homogenisation/complex_moduli.hpp"
#include "homogenisation/run/isotropic_mean.hpp"
#include "virtual_test/bulk_test.hpp"

namespace breccia::cli {

std::vector<const TestResult*> shown_tests(const StageResult& stage) {
  const bool has_limits =
      std::ranges::any_of(stage.tests, [](const TestResult& test) { return test.id.grid.is_extrapolated(); });
  std::vector<const TestResult*> shown;
  for (const auto& test : stage.tests) {
    if (is_replaced_by_mean(test.id, stage.dimensions, stage.tests)) continue;
    if (!has_limits || test.id.grid.is_extrapolated()) shown.push_back(&test);
  }
  return shown;
}

std::string modulus_in_words(TestLoad load, int dimensions) {
  if (load.is_bulk()) return std::string(symbol_of_bulk_test(dimensions));
  if (load.is_isotropic() || load == Load::shear) return "G";
  constexpr std::string_view shear = "shear-";
  return "G, " + name_of(load).substr(shear.size());
}

bool has_known_error(const TestResult& test) {
  return std::ranges::any_of(test.errors, [](const ModulusError& error) { return error.whole().has_value(); });
}

std::string error_at(const TestResult& test, double time) {
  return error_text(whole_error_at(test, time));
}

std::string error_text(const std::optional<double>& error) {
  return error ? fmt::format("{:.2g} %", 100.0 * *error) : "unknown";
}

}  // namespace breccia::cli
