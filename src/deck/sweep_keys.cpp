#include "deck/sweep_keys.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "deck/rounding.hpp"
#include "io/units.hpp"

namespace breccia {

namespace {

constexpr std::int64_t most_tasks = 1000;

enum class Spacing { linear, logarithmic };

/// Number of integers from the first to the last; unsigned, since it may exceed the largest signed integer.
std::uint64_t distance(std::int64_t from, std::int64_t to) {
  return static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from);
}

std::vector<Scalar> integers_from(std::int64_t from, std::uint64_t step, std::int64_t count) {
  std::vector<Scalar> values;
  auto value = static_cast<std::uint64_t>(from);
  for (std::int64_t i = 0; i < count; ++i, value += step) values.emplace_back(static_cast<std::int64_t>(value));
  return values;
}

std::vector<Scalar> numbers_between(double from, double to, std::int64_t count, Spacing spacing) {
  std::vector<Scalar> values;
  for (std::int64_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double value = spacing == Spacing::linear ? std::lerp(from, to, share)
                                                    : std::exp(std::lerp(std::log(from), std::log(to), share));
    values.emplace_back(as_typed(value));
  }
  return values;
}

/// `{ from = 1, to = 5 }`
std::vector<Scalar> read_steps_of_one(const Section& range) {
  if (range.kind("from") != Kind::integer || range.kind("to") != Kind::integer) {
    range.report("", "expected count, the number of values; only between integers it may be left out");
    return {};
  }
  const auto from = range.integer("from"), to = range.integer("to");
  if (to <= from) {
    range.report("to", fmt::format("expected more than {}, got {}", from, to));
    return {};
  }
  const double count = static_cast<double>(distance(from, to)) + 1.0;
  if (count > static_cast<double>(most_tasks)) {
    range.report("to", fmt::format("expected at most {} values, got {:.6g}", most_tasks, count));
    return {};
  }
  return integers_from(from, 1, static_cast<std::int64_t>(count));
}

/// Reads a number with a unit, such as "48 um" or "6 points"; nothing after a mistake was reported.
std::optional<NumberAndUnit> read_end(const Section& range, const std::string& key) {
  if (range.kind(key) != Kind::text) {
    range.report(key, "expected a number with its unit, as the other end of the range has one");
    return std::nullopt;
  }
  const auto text = range.text(key);
  auto end = split_quantity(text);
  if (end && !end->unit.empty()) return end;
  range.report(key, fmt::format(R"(expected a number with its unit, such as "48 um", got "{}")", text));
  return std::nullopt;
}

/// `{ from = "-40 degC", to = "60 degC", count = 3 }`, in the unit of the first.
std::vector<Scalar> read_quantities(const Section& range, std::int64_t count, Spacing spacing) {
  const auto from = read_end(range, "from"), to = read_end(range, "to");
  if (!from || !to || count == 0) return {};
  const auto last = number_in_unit(*to, from->unit);
  if (!last) {
    range.report(
        "to",
        fmt::format(
            R"(expected a quantity in "{}", the unit of from, or in another that can be converted to it, got "{}")",
            from->unit, range.text("to")));
    return {};
  }
  if (!(*last > from->number)) {
    range.report("to", fmt::format(R"(expected more than "{}", got "{}")", range.text("from"), range.text("to")));
    return {};
  }
  if (spacing == Spacing::logarithmic && !(from->number > 0.0)) {
    range.report("from", fmt::format(R"(expected a positive quantity, got "{}")", range.text("from")));
    return {};
  }
  std::vector<Scalar> values;
  for (const auto& number : numbers_between(from->number, *last, count, spacing)) {
    values.emplace_back(fmt::format("{} {}", plain_text(number), from->unit));
  }
  return values;
}

/// `{ from = 0.5, to = 0.7, count = 5, spacing = "logarithmic" }`
std::vector<Scalar> read_counted(const Section& range) {
  const auto count = range.integer("count", {.lower = 2.0, .upper = static_cast<double>(most_tasks)});
  auto spacing = Spacing::linear;
  if (range.has("spacing")) {
    spacing = range.choice<Spacing>("spacing", {{"linear", Spacing::linear}, {"logarithmic", Spacing::logarithmic}})
                  .value_or(Spacing::linear);
  }
  if (range.kind("from") == Kind::text || range.kind("to") == Kind::text) return read_quantities(range, count, spacing);
  const auto ends = spacing == Spacing::linear ? Range() : Range::positive();
  const double from = range.number("from", ends), to = range.number("to", ends);
  if (std::isnan(from) || std::isnan(to) || count == 0) return {};
  if (to <= from) {
    range.report("to", fmt::format("expected more than {}, got {}", from, to));
    return {};
  }
  const bool between_integers = range.kind("from") == Kind::integer && range.kind("to") == Kind::integer;
  if (between_integers && spacing == Spacing::linear) {
    const auto first = range.integer("from");
    const auto whole = distance(first, range.integer("to")), parts = static_cast<std::uint64_t>(count - 1);
    if (whole % parts == 0) return integers_from(first, whole / parts, count);
  }
  return numbers_between(from, to, count, spacing);
}

/// Whether a table of [sweep] is a range of values, `{ from = ..., to = ... }`, instead of a table of further keys.
/// Deck keys named `from` or `to` must therefore have arrays here.
bool is_range(const Section& table) {
  const auto is_end = [&](const std::string& key) {
    const auto kind = table.kind(key);
    return kind != Kind::absent && kind != Kind::array && kind != Kind::table;
  };
  return is_end("from") || is_end("to");
}

std::vector<LocatedScalar> read_range(const Section& range, const Location& location) {
  std::vector<LocatedScalar> values;
  if (!range.has("count")) range.refuse({"spacing"}, "goes with count");
  for (auto& value : range.has("count") ? read_counted(range) : read_steps_of_one(range)) {
    values.push_back({std::move(value), location});
  }
  return values;
}

std::vector<LocatedScalar> read_list(const Section& section, const std::string& key) {
  auto values = section.scalars(key);
  for (auto value = values.begin(); value != values.end(); ++value) {
    const bool is_repeated = std::any_of(values.begin(), value, [&](const auto& earlier) {
      return plain_text(earlier.value) == plain_text(value->value);
    });
    if (is_repeated) section.report(key, fmt::format("{} stands here twice", toml_text(value->value)));
  }
  return values;
}

/// A key as a step of a path: in quotes if it has dots or spaces, which would divide it or get lost.
std::string step_of(const std::string& key) {
  const bool is_one_step = key.find_first_of(". ") == std::string::npos;
  return is_one_step ? key : fmt::format("\"{}\"", key);
}

/// Reads the keys of `[sweep]`, which are paths, and of the tables in it, where each key is a step of a path.
void read_table(const Section& section, const std::string& parent, std::vector<KeyValues>& keys) {
  if (section.keys().empty())
    section.report("", "expected keys with values, such as \"tests.points_per_decade\" = [10, 20]");
  for (const auto& key : section.keys()) {
    const auto path = parent.empty() ? key : fmt::format("{}.{}", parent, step_of(key));
    if (section.kind(key) == Kind::array) {
      keys.push_back({path, section.location_of_key(key), read_list(section, key)});
    } else if (section.kind(key) != Kind::table) {
      section.report(key, "expected an array such as [1, 2], or a range such as { from = 1, to = 5 }");
    } else if (const auto table = section.section(key); is_range(table)) {
      keys.push_back({path, section.location_of_key(key), read_range(table, section.location_of_value(key))});
    } else {
      read_table(table, path, keys);
    }
  }
}

}  // namespace

std::vector<KeyValues> read_keys(const Section& deck) {
  std::vector<KeyValues> keys;
  const auto section = deck.optional_section("sweep");
  if (!section) return keys;
  read_table(*section, "", keys);
  std::erase_if(keys, [](const KeyValues& key) { return key.values.empty(); });
  double combinations = 1.0;
  for (const auto& key : keys) combinations *= static_cast<double>(key.values.size());
  if (combinations > static_cast<double>(most_tasks)) {
    deck.report("sweep", fmt::format("expected at most {} tasks, got {:.6g}", most_tasks, combinations));
    return {};
  }
  return keys;
}

}  // namespace breccia
