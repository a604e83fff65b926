#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

#include "deckfile/deck.hpp"
#include "deckfile/deck_tree.hpp"
#include "deckfile/distribution.hpp"
#include "deckfile/parsed_value.hpp"

namespace breccia {

using detail::DeckArray;
using detail::DeckTable;
using detail::DeckValue;
using detail::expected_but_got;
using detail::ParsedValue;
using detail::read_boolean;
using detail::read_choice;
using detail::read_fraction;
using detail::read_integer;
using detail::read_number;
using detail::read_quantity;
using detail::read_scalar;
using detail::read_string;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::string wanted(Dimension dimension) {
  return fmt::format("{} such as \"{}\"", with_article(dimension), example(dimension));
}

/// The value that was read, or nothing after a mistake was reported.
template <class T>
std::optional<T> settle(const Section& section, const std::string& key, ParsedValue<T> parsed) {
  if (!parsed.value) section.report(key, parsed.mistake);
  return std::move(parsed.value);
}

/// Adds an uncertain input, once.
void remember(detail::DeckState& state, UncertainInput input) {
  const auto known = std::ranges::find(state.uncertain_inputs, input.name, &UncertainInput::name);
  if (known == state.uncertain_inputs.end()) state.uncertain_inputs.push_back(std::move(input));
}

}  // namespace

Section::Section(detail::DeckState& state, const DeckTable* table, std::string path)
    : state_(&state), table_(table), path_(std::move(path)) {
  if (table_ != nullptr) state_->uses[table_].path = path_;
}

std::string Section::path_of(const std::string& key) const {
  return detail::joined(path_, key);
}

const DeckValue* Section::find(const std::string& key) const {
  if (table_ == nullptr) return nullptr;
  state_->uses[table_].asked.insert(key);
  const auto* value = detail::find(*table_, key);
  return value == nullptr ? nullptr : &first_choice(key, *value);
}

/// The first of the values of `{ any = [...] }`; another value as it is.
const DeckValue& Section::first_choice(const std::string& key, const DeckValue& value) const {
  const auto* table = std::get_if<DeckTable>(&value.content);
  if (table == nullptr || table->entries.size() != 1 || table->entries.front().key != "any") return value;
  const auto& all = table->entries.front().value;
  const auto* array = std::get_if<DeckArray>(&all.content);
  Choices choices;
  for (const auto& one : array == nullptr ? std::vector<DeckValue>() : array->values) {
    if (auto scalar = detail::scalar_of(one)) choices.values.push_back(*std::move(scalar));
  }
  if (choices.values.size() < 2 || choices.values.size() < array->values.size()) {
    state_->mistakes.push_back(
        {all.location, fmt::format("{}.any: expected an array of two values or more, such as [1, 2]", path_of(key))});
    return value;
  }
  remember(*state_, {path_of(key), "", std::move(choices)});
  return array->values.front();
}

/// The median of a distribution; nothing after a mistake was reported.
std::optional<double> Section::median(const std::string& key, const NumberReader& reader, const Range& range,
                                      std::string_view unit) const {
  const auto known = read_distribution(*this, key, reader, range);
  if (!known) return std::nullopt;
  remember(*state_, {path_of(key), std::string(unit), *known});
  return breccia::median(*known);
}

const DeckValue* Section::require(const std::string& key, const std::string& expected) const {
  const auto* value = find(key);
  if (value == nullptr) report(key, fmt::format("missing, expected {}", expected));
  return value;
}

Kind Section::kind(const std::string& key) const {
  const auto* value = find(key);
  return value == nullptr ? Kind::absent : kind_of(*value);
}

bool Section::is_distribution(const std::string& key) const {
  const auto* value = find(key);
  const auto* table = value == nullptr ? nullptr : std::get_if<DeckTable>(&value->content);
  if (table == nullptr) return false;
  constexpr std::array<std::string_view, 5> keys = {"value", "sd", "factor", "from", "to"};
  return std::ranges::any_of(keys, [&](std::string_view one) { return detail::find(*table, one) != nullptr; });
}

std::vector<std::string> Section::keys() const {
  std::vector<std::string> all;
  if (table_ == nullptr) return all;
  for (const auto& entry : table_->entries) all.push_back(entry.key);
  state_->uses[table_].asked.insert(all.begin(), all.end());
  return all;
}

std::string Section::exactly_one(const std::vector<std::string>& keys) const {
  std::vector<std::string> present;
  for (const auto& key : keys) {
    if (has(key)) present.push_back(key);
  }
  if (present.size() == 1) return present.front();
  const auto expected = fmt::format("expected exactly one of {}", fmt::join(keys, ", "));
  if (present.empty()) {
    report("", expected);
  } else {
    report(present.back(), fmt::format("{}, got {}", expected, fmt::join(present, " and ")));
  }
  return {};
}

void Section::report(const std::string& key, const std::string& message) const {
  if (table_ == nullptr) return;
  const auto* value = key.empty() ? nullptr : find(key);
  const auto& location = value != nullptr ? value->location : table_->location;
  const auto path = key.empty() ? path_ : path_of(key);
  state_->mistakes.push_back({location, path.empty() ? message : fmt::format("{}: {}", path, message)});
}

void Section::remark(const std::string& key, const std::string& message) const {
  state_->remarks.push_back(fmt::format("{}: {}", path_of(key), message));
}

void Section::report_errors_of(const std::string& key, const std::function<void()>& action) const {
  try {
    action();
  } catch (const InputError& error) {
    std::string_view lines = error.what();
    while (!lines.empty()) {
      const auto line = lines.substr(0, lines.find('\n'));
      report(key, std::string(line));
      lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    }
  }
}

Location Section::location_of_key(const std::string& key) const {
  return std::ranges::find(table_->entries, key, &detail::DeckEntry::key)->key_location;
}

Location Section::location_of_value(const std::string& key) const {
  return find(key)->location;
}

void Section::refuse(const std::vector<std::string>& keys, const std::string& reason) const {
  for (const auto& key : keys) {
    // A missing key is not marked as known, so that it is not suggested for other keys.
    if (table_ != nullptr && detail::find(*table_, key) != nullptr) report(key, reason);
  }
}

double Section::quantity(const std::string& key, Dimension dimension, const Range& range) const {
  if (require(key, wanted(dimension)) == nullptr) return not_a_number;
  return optional_quantity(key, dimension, range).value_or(not_a_number);
}

std::optional<double> Section::optional_quantity(const std::string& key, Dimension dimension,
                                                 const Range& range) const {
  if (is_distribution(key)) return median(key, reader_of(dimension), range, si_unit(dimension));
  const auto* value = find(key);
  return value == nullptr ? std::nullopt : settle(*this, key, read_quantity(*value, dimension, range));
}

double Section::number(const std::string& key, const Range& range) const {
  if (require(key, described(range, "number")) == nullptr) return not_a_number;
  return optional_number(key, range).value_or(not_a_number);
}

std::optional<double> Section::optional_number(const std::string& key, const Range& range) const {
  if (is_distribution(key)) return median(key, reader_of(std::nullopt), range, "");
  const auto* value = find(key);
  return value == nullptr ? std::nullopt : settle(*this, key, read_number(*value, range));
}

double Section::fraction(const std::string& key, const Range& range) const {
  const auto* value = require(key, described(range, "number"));
  if (value == nullptr) return not_a_number;
  if (is_distribution(key)) return median(key, reader_of_fractions(), range, "").value_or(not_a_number);
  return settle(*this, key, read_fraction(*value, range)).value_or(not_a_number);
}

std::int64_t Section::integer(const std::string& key, const Range& range) const {
  if (require(key, described(range, "integer")) == nullptr) return 0;
  return optional_integer(key, range).value_or(0);
}

std::optional<std::int64_t> Section::optional_integer(const std::string& key, const Range& range) const {
  const auto* value = find(key);
  return value == nullptr ? std::nullopt : settle(*this, key, read_integer(*value, range));
}

std::optional<bool> Section::optional_boolean(const std::string& key) const {
  const auto* value = find(key);
  return value == nullptr ? std::nullopt : settle(*this, key, read_boolean(*value));
}

std::string Section::text(const std::string& key) const {
  if (require(key, "text in quotes") == nullptr) return {};
  const auto text = optional_text(key);
  if (text && text->empty()) report(key, "expected a text that is not empty");
  return text.value_or("");
}

std::optional<std::string> Section::optional_text(const std::string& key) const {
  const auto* value = find(key);
  return value == nullptr ? std::nullopt : settle(*this, key, read_string(*value));
}

FileCache& Section::file_cache() const {
  return *state_->file_cache;
}

std::filesystem::path Section::file(const std::string& key) const {
  const auto* value = require(key, "the name of a file");
  // The other files that it may be belong to the deck, too.
  const auto known = std::ranges::find(state_->uncertain_inputs, path_of(key), &UncertainInput::name);
  if (known != state_->uncertain_inputs.end()) {
    for (const auto& one : std::get<Choices>(known->known).values) {
      if (const auto* const other = std::get_if<std::string>(&one)) static_cast<void>(file(key, *other));
    }
  }
  const auto name = value == nullptr ? std::nullopt : settle(*this, key, read_string(*value));
  return name ? file(key, *name) : std::filesystem::path();
}

std::filesystem::path Section::file(const std::string& key, const std::string& name) const {
  auto path = (state_->path.parent_path() / name).lexically_normal();
  std::error_code is_no_name_of_a_file;  // too long, for example
  if (std::filesystem::is_regular_file(path, is_no_name_of_a_file)) {
    state_->files.insert(path);
    return path;
  }
  report(key, fmt::format("no such file: {}", path.string()));
  return {};
}

std::optional<std::size_t> Section::choice_index(const std::string& key, const std::vector<std::string>& words) const {
  const auto* value = require(key, fmt::format("one of \"{}\"", fmt::join(words, "\", \"")));
  return value == nullptr ? std::nullopt : settle(*this, key, read_choice(*value, words));
}

/// The values of the elements of an array; a bad number becomes NaN, any other bad element is left out.
template <class Read>
auto Section::elements(const std::string& key, const std::string& expected, const Read& read) const {
  using Element = typename decltype(read(std::declval<const DeckValue&>()).value)::value_type;
  std::vector<Element> all;
  const auto* value = require(key, expected);
  if (value == nullptr) return all;
  const auto* array = std::get_if<DeckArray>(&value->content);
  if (array == nullptr) {
    report(key, expected_but_got(expected, *value));
    return all;
  }
  if (array->values.empty()) report(key, "expected at least one, got an empty array");
  for (const auto& element : array->values) {
    auto parsed = read(element);
    if (parsed.value) {
      all.push_back(std::move(*parsed.value));
      continue;
    }
    state_->mistakes.push_back({element.location, fmt::format("{}: {}", path_of(key), parsed.mistake)});
    if constexpr (std::is_same_v<Element, double>) all.push_back(not_a_number);
  }
  return all;
}

std::vector<double> Section::quantities(const std::string& key, Dimension dimension, const Range& range) const {
  return elements(key, fmt::format("an array such as [\"{}\"]", example(dimension)),
                  [&](const DeckValue& value) { return read_quantity(value, dimension, range); });
}

std::vector<double> Section::numbers(const std::string& key, const Range& range) const {
  return elements(key, "an array of numbers", [&](const DeckValue& value) { return read_number(value, range); });
}

std::vector<std::int64_t> Section::integers(const std::string& key, const Range& range) const {
  return elements(key, "an array of integers", [&](const DeckValue& value) { return read_integer(value, range); });
}

std::vector<std::size_t> Section::choice_indices(const std::string& key, const std::vector<std::string>& words) const {
  return elements(key, fmt::format("an array such as [\"{}\"]", words.front()),
                  [&](const DeckValue& value) { return read_choice(value, words); });
}

std::vector<LocatedScalar> Section::scalars(const std::string& key) const {
  return elements(key, "an array such as [1, 2]", read_scalar);
}

Section Section::section(const std::string& key) const {
  const auto* value = require(key, "a table");
  const auto* table = value == nullptr ? nullptr : std::get_if<DeckTable>(&value->content);
  if (value != nullptr && table == nullptr) report(key, expected_but_got("a table", *value));
  return {*state_, table, path_of(key)};
}

std::optional<Section> Section::optional_section(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  return section(key);
}

std::vector<Section> Section::sections(const std::string& key) const {
  std::vector<Section> all;
  const auto* value = require(key, "an array of tables");
  if (value == nullptr) return all;
  const auto* array = std::get_if<DeckArray>(&value->content);
  if (array == nullptr) {
    const bool may_be_header = kind_of(*value) == Kind::table;
    const auto hint = may_be_header ? fmt::format(": write [[{0}]] in the place of [{0}]", path_of(key)) : "";
    report(key, expected_but_got("an array of tables", *value) + hint);
    return all;
  }
  if (array->values.empty()) report(key, "expected at least one, got an empty array");
  for (std::size_t i = 0; i < array->values.size(); ++i) {
    const auto& element = array->values[i];
    const auto* table = std::get_if<DeckTable>(&element.content);
    const auto path = detail::joined(path_of(key), element_name(element, i));
    if (table == nullptr) {
      state_->mistakes.push_back({element.location, fmt::format("{}: {}", path, expected_but_got("a table", element))});
    }
    all.push_back(Section(*state_, table, path));
  }
  return all;
}

}  // namespace breccia
