#include "deck/distribution.hpp"

#include <cmath>

#include <fmt/format.h>

namespace breccia {
namespace {

/// Reads the numbers of a distribution.
class DistributionReader {
 public:
  DistributionReader(const Section& table, std::optional<Dimension> dimension, const Range& range)
      : table_(table), dimension_(dimension), range_(range) {}

  [[nodiscard]] std::optional<Distribution> read() const {
    const auto form = table_.exactly_one({"sd", "factor", "to"});
    std::optional<Distribution> found;
    if (form == "sd") {
      found = Normal{number("value", range_), number("sd", Range::positive())};
      refuse_far_tails(std::get<Normal>(*found));
    } else if (form == "factor") {
      if (std::isfinite(range_.upper)) {
        table_.report("factor", "expected sd, or from and to, of a number that has a largest value");
      }
      found = LogNormal{number("value", range_), table_.number("factor", Range::positive())};
    } else if (form == "to") {
      // No value between the ends is one of them.
      const Range ends = {.lower = range_.lower, .upper = range_.upper};
      const double from = number("from", ends), to = number("to", ends);
      found = is_logarithmic() ? Distribution(LogUniform{from, to}) : Distribution(Uniform{from, to});
    } else {
      table_.accept_all_keys();
    }
    if (!found || std::isnan(median(*found))) return std::nullopt;
    const auto mistake = mistake_in(*found);
    if (mistake.empty()) return found;
    table_.report(form, mistake);
    return std::nullopt;
  }

 private:
  [[nodiscard]] double number(const std::string& key, const Range& range) const {
    return dimension_ ? table_.quantity(key, *dimension_, range) : table_.number(key, range);
  }
  [[nodiscard]] bool is_logarithmic() const {
    enum class Scale { linear, logarithmic };
    if (!table_.has("scale")) return false;
    return table_.choice<Scale>("scale", {{"linear", Scale::linear}, {"logarithmic", Scale::logarithmic}}) ==
           Scale::logarithmic;
  }
  /// Reports a normal distribution that has values beyond the range.
  void refuse_far_tails(const Normal& normal) const {
    constexpr double far = 4.0;
    const double lower = normal.mean - far * normal.deviation, upper = normal.mean + far * normal.deviation;
    if (lower >= range_.lower && upper <= range_.upper) return;
    if (std::isnan(lower) || std::isnan(upper)) return;
    table_.report("sd",
                  "expected less than a quarter of the distance to the values that are not allowed; a number "
                  "known within a factor is { value = ..., factor = ... }");
  }

  const Section& table_;
  std::optional<Dimension> dimension_;
  const Range& range_;
};

}  // namespace

std::optional<Distribution> read_distribution(const Section& section, const std::string& key,
                                              std::optional<Dimension> dimension, const Range& range) {
  return DistributionReader(section.section(key), dimension, range).read();
}

}  // namespace breccia
