#include "cli/calibration_tables.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "io/display.hpp"

namespace breccia::cli {
namespace {

struct InWords {
  const std::string& unit;

  std::string operator()(const Normal& normal) const {
    return fmt::format("{} +- {}", number_in_words(normal.mean, unit), number_in_words(normal.deviation, unit));
  }
  std::string operator()(const LogNormal& normal) const {
    constexpr double near_one = 1.2;
    if (normal.factor < near_one) {
      return fmt::format("{} +- {:.2g} %", number_in_words(normal.median, unit), 100.0 * (normal.factor - 1.0));
    }
    return fmt::format("{}, within a factor {}", number_in_words(normal.median, unit), three_digits(normal.factor));
  }
  std::string operator()(const Uniform& uniform) const { return range(uniform.from, uniform.to); }
  std::string operator()(const LogUniform& uniform) const { return range(uniform.from, uniform.to); }

  [[nodiscard]] std::string range(double from, double to) const {
    return fmt::format("{} to {}", number_in_words(from, unit), number_in_words(to, unit));
  }
};

}  // namespace

std::string in_words(const Distribution& distribution, const std::string& unit) {
  return std::visit(InWords{unit}, distribution);
}

std::string table_of_estimates(const std::vector<Estimate>& estimates) {
  std::size_t width = 7;
  for (const auto& one : estimates) width = std::max(width, one.name.size());
  auto text =
      fmt::format("{:<{}}  {:>10}  {:>22}  {:>8}  before\n", "unknown", width, "found", "95 % interval", "learned");
  for (const auto& one : estimates) {
    const auto interval = fmt::format("{} to {}", number_in_words(one.interval.lower, one.unit),
                                      number_in_words(one.interval.upper, one.unit));
    text +=
        fmt::format("{:<{}}  {:>10}  {:>22}  {:>6.0f} %  {}\n", one.name, width, number_in_words(one.value, one.unit),
                    interval, 100.0 * one.learned, in_words(one.prior, one.unit));
  }
  return text;
}

}  // namespace breccia::cli
