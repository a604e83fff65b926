#include "deckfile/distribution.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace breccia {
namespace {

/// Whether a number of a distribution was not read, after a mistake was reported.
struct LacksNumber {
  bool operator()(const Normal& known) const { return std::isnan(known.mean) || std::isnan(known.deviation); }
  bool operator()(const LogNormal& known) const { return std::isnan(known.median) || std::isnan(known.factor); }
  bool operator()(const Uniform& known) const { return std::isnan(known.from) || std::isnan(known.to); }
  bool operator()(const LogUniform& known) const { return std::isnan(known.from) || std::isnan(known.to); }
};

/// Reads the numbers of a distribution.
class DistributionReader {
 public:
  DistributionReader(const Section& table, const NumberReader& reader, const Range& range)
      : table_(table), reader_(reader), range_(range) {}

  [[nodiscard]] std::optional<Distribution> read() const {
    const auto form = table_.exactly_one({"sd", "factor", "to"});
    std::optional<Distribution> found;
    if (form == "sd") {
      found = Normal{number("value", range_), reader_.deviation(table_, "sd", Range::positive())};
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
    if (!found || std::visit(LacksNumber{}, *found)) return std::nullopt;
    const auto mistake = mistake_in(*found);
    if (mistake.empty()) return found;
    table_.report(form, mistake);
    return std::nullopt;
  }

 private:
  [[nodiscard]] double number(const std::string& key, const Range& range) const {
    if (table_.kind(key) != Kind::table) return reader_.value(table_, key, range);
    table_.report(key, "expected a number, not a distribution within a distribution");
    table_.section(key).accept_all_keys();
    return std::numeric_limits<double>::quiet_NaN();
  }
  [[nodiscard]] bool is_logarithmic() const {
    enum class Scale { linear, logarithmic };
    if (!table_.has("scale")) return false;
    return table_.choice<Scale>("scale", {{"linear", Scale::linear}, {"logarithmic", Scale::logarithmic}}) ==
           Scale::logarithmic;
  }
  /// Reports a normal distribution that has values beyond the range.
  void refuse_far_tails(const Normal& normal) const {
    const double reach = most_score * normal.deviation;
    const double lower = normal.mean - reach, upper = normal.mean + reach;
    if (accepts(range_, lower) && accepts(range_, upper)) return;
    if (std::isnan(lower) || std::isnan(upper)) return;
    table_.report("sd",
                  "expected less than a quarter of the distance to the values that are not allowed; a number "
                  "known within a factor is { value = ..., factor = ... }");
  }

  const Section& table_;
  const NumberReader& reader_;
  const Range& range_;
};

}  // namespace

NumberReader reader_of(std::optional<Dimension> dimension) {
  const auto read_as = [](std::optional<Dimension> as) {
    return [as](const Section& table, const std::string& key, const Range& range) {
      return as ? table.quantity(key, *as, range) : table.number(key, range);
    };
  };
  const bool is_temperature = dimension == Dimension::temperature;
  return {read_as(dimension), read_as(is_temperature ? Dimension::temperature_difference : dimension)};
}

NumberReader reader_of_fractions() {
  const auto read = [](const Section& table, const std::string& key, const Range& range) {
    return table.fraction(key, range);
  };
  return {read, read};
}

std::optional<Distribution> read_distribution(const Section& section, const std::string& key,
                                              const NumberReader& reader, const Range& range) {
  return DistributionReader(section.section(key), reader, range).read();
}

}  // namespace breccia
