#include "deckfile/parsed_value.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "io/nearest_name.hpp"
#include "io/percentage.hpp"
#include "io/printable.hpp"

namespace breccia::detail {
namespace {

template <class T>
ParsedValue<T> wrong(std::string mistake) {
  return {std::nullopt, std::move(mistake)};
}

constexpr auto printable_text = "text without line breaks, tabs and other control characters";

}  // namespace

std::string expected_but_got(std::string_view expected, const DeckValue& value) {
  return fmt::format("expected {}, got {}", expected, shown(value));
}

ParsedValue<double> read_quantity(const DeckValue& value, Dimension dimension, const Range& range) {
  const auto* text = std::get_if<std::string>(&value.content);
  if (text == nullptr) {
    return wrong<double>(expected_but_got(
        fmt::format("{} with its unit, such as \"{}\"", with_article(dimension), example(dimension)), value));
  }
  try {
    const double quantity = parse_quantity(*text, dimension);
    if (accepts(range, quantity)) return {quantity, {}};
  } catch (const InputError& error) {
    return wrong<double>(error.what());
  }
  return wrong<double>(expected_but_got(described(range, dimension), value));
}

ParsedValue<double> read_number(const DeckValue& value, const Range& range) {
  double number = std::numeric_limits<double>::quiet_NaN();
  if (const auto* floating = std::get_if<double>(&value.content)) number = *floating;
  if (const auto* integer = std::get_if<std::int64_t>(&value.content)) number = static_cast<double>(*integer);
  if (accepts(range, number)) return {number, {}};
  return wrong<double>(expected_but_got(described(range, "number"), value));
}

ParsedValue<double> read_fraction(const DeckValue& value, const Range& range) {
  if (const auto* text = std::get_if<std::string>(&value.content)) {
    const auto share = parse_percentage(*text);
    if (share && accepts(range, *share)) return {*share, {}};
    return wrong<double>(expected_but_got(described(range, "number") + R"(, or per cent as in "35 %")", value));
  }
  auto number = read_number(value, range);
  if (number.value) return number;
  return wrong<double>(expected_but_got(described(range, "number") + R"(, or per cent as in "35 %")", value));
}

ParsedValue<std::int64_t> read_integer(const DeckValue& value, const Range& range) {
  const auto* integer = std::get_if<std::int64_t>(&value.content);
  if (integer != nullptr && accepts(range, static_cast<double>(*integer))) return {*integer, {}};
  return wrong<std::int64_t>(expected_but_got(described(range, "integer"), value));
}

ParsedValue<bool> read_boolean(const DeckValue& value) {
  const auto* boolean = std::get_if<bool>(&value.content);
  if (boolean != nullptr) return {*boolean, {}};
  return wrong<bool>(expected_but_got("true or false", value));
}

ParsedValue<std::string> read_string(const DeckValue& value) {
  const auto* text = std::get_if<std::string>(&value.content);
  if (text != nullptr && is_printable(*text)) return {*text, {}};
  if (text != nullptr) return wrong<std::string>(expected_but_got(printable_text, value));
  return wrong<std::string>(expected_but_got("text in quotes", value));
}

ParsedValue<LocatedScalar> read_scalar(const DeckValue& value) {
  const auto* text = std::get_if<std::string>(&value.content);
  if (text != nullptr && !is_printable(*text)) return wrong<LocatedScalar>(expected_but_got(printable_text, value));
  if (auto scalar = scalar_of(value)) return {LocatedScalar{*std::move(scalar), value.location}, {}};
  return wrong<LocatedScalar>(expected_but_got("a number, text, true or false", value));
}

ParsedValue<std::size_t> read_choice(const DeckValue& value, const std::vector<std::string>& words) {
  const auto expected = words.size() == 1 ? fmt::format("\"{}\" (nothing else is available)", words.front())
                                          : fmt::format("one of \"{}\"", fmt::join(words, "\", \""));
  const auto* text = std::get_if<std::string>(&value.content);
  if (text == nullptr) return wrong<std::size_t>(expected_but_got(expected, value));
  const auto word = std::ranges::find(words, *text);
  if (word != words.end()) return {static_cast<std::size_t>(word - words.begin()), {}};
  const auto nearest = nearest_name(*text, words);
  const auto hint = nearest ? fmt::format(", did you mean \"{}\"?", *nearest) : "";
  return wrong<std::size_t>(expected_but_got(expected, value) + hint);
}

}  // namespace breccia::detail
