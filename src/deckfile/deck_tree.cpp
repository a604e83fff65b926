#include "deckfile/deck_tree.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "breccia/error.hpp"

namespace breccia::detail {

namespace {

Location location_of(const toml::source_region& region) {
  return {{}, region.begin.line, region.begin.column};
}

DeckTable convert(const toml::table& table);

DeckValue convert(const toml::node& node) {
  const auto location = location_of(node.source());
  if (const auto* table = node.as_table()) return {location, convert(*table)};
  if (const auto* array = node.as_array()) {
    DeckArray values;
    for (const auto& element : *array) values.values.push_back(convert(element));
    return {location, std::move(values)};
  }
  if (const auto* text = node.as_string()) return {location, text->get()};
  if (const auto* integer = node.as_integer()) return {location, integer->get()};
  if (const auto* number = node.as_floating_point()) return {location, number->get()};
  if (const auto* boolean = node.as_boolean()) return {location, boolean->get()};
  return {location, Date()};
}

DeckTable convert(const toml::table& table) {
  DeckTable converted{location_of(table.source()), {}, table.is_inline()};
  for (const auto& [key, node] : table) {
    converted.entries.push_back({std::string(key.str()), location_of(key.source()), convert(node)});
  }
  std::ranges::sort(converted.entries, {}, [](const DeckEntry& entry) {
    return std::tuple(entry.key_location.line, entry.key_location.column);
  });
  return converted;
}

/// The first typographic quote in a line that is outside of TOML strings; empty if there is none.
std::string_view first_typographic_quote(std::string_view text, std::uint32_t line) {
  for (; line > 1 && !text.empty(); --line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  text = text.substr(0, text.find('\n'));
  char open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (open == 0 && (text[i] == '"' || text[i] == '\'')) {
      open = text[i];
    } else if (open != 0 && text[i] == open) {
      open = 0;
    }
    for (const std::string_view quote : {"“", "”", "„", "‟", "‘", "’", "‚", "«", "»", "″", "´"}) {
      if (open == 0 && text.substr(i).starts_with(quote)) return text.substr(i, quote.size());
    }
  }
  return {};
}

/// Refuses deeply nested tables, as in `a.a.a. ... = 1`, which would exhaust the stack of the parser.
void refuse_endless_keys(const std::filesystem::path& path, const std::string& text) {
  constexpr std::size_t most = 4096;
  std::uint32_t line = 1;
  std::size_t dots = 0;
  for (const char letter : text) {
    if (letter == '\n') ++line;
    if (letter == '\n' || letter == ',' || letter == '=') dots = 0;
    if (letter == '.' && ++dots > most) {
      throw InputError(
          fmt::format("{}:{}:1: expected a key, got one with more than {} dots", path.string(), line, most));
    }
  }
}

/// The message of the parser about a mistake. Typographic quotes get a message of their own, since that of the parser
/// does not mention them.
std::string description_of(const std::string& text, const toml::parse_error& error) {
  const auto typographic = first_typographic_quote(text, error.source().begin.line);
  if (typographic.empty()) return std::string(error.description());
  return fmt::format("the character {} is no quote of TOML: write \" in its place", typographic);
}

/// Collects the values of a deck with their paths.
class ValuesOfDeck {
 public:
  void add_entries(const std::string& path, const DeckTable& table) {
    for (const auto& entry : table.entries) add(joined(path, entry.key), entry.value);
  }
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> all() && { return std::move(values_); }

 private:
  void add(const std::string& path, const DeckValue& value) {
    const auto is_table = [](const DeckValue& one) { return kind_of(one) == Kind::table; };
    if (const auto* table = std::get_if<DeckTable>(&value.content)) {
      add_entries(path, *table);
      return;
    }
    const auto* array = std::get_if<DeckArray>(&value.content);
    if (array == nullptr) {
      values_.emplace_back(path, content_of(value));
    } else if (std::ranges::any_of(array->values, is_table)) {
      for (std::size_t i = 0; i < array->values.size(); ++i) {
        add(joined(path, element_name(array->values[i], i)), array->values[i]);
      }
    } else {
      std::vector<std::string> texts;
      for (const auto& element : array->values) texts.push_back(content_of(element));
      values_.emplace_back(path, fmt::format("[{}]", fmt::join(texts, ", ")));
    }
  }

  std::vector<std::pair<std::string, std::string>> values_;
};

}  // namespace

DeckTable parse_deck(const std::filesystem::path& path, const std::string& text) {
  refuse_endless_keys(path, text);
  try {
    return convert(toml::parse(std::string_view(text), std::string_view(path.native())));
  } catch (const toml::parse_error& error) {
    const auto location = location_of(error.source());
    throw InputError(fmt::format("{}:{}:{}: not TOML: {}", path.string(), location.line, location.column,
                                 description_of(text, error)));
  }
}

void set_location(DeckValue& value, const Location& location) {
  value.location = location;
  if (auto* table = std::get_if<DeckTable>(&value.content)) set_location(*table, location);
  if (auto* array = std::get_if<DeckArray>(&value.content)) {
    for (auto& element : array->values) set_location(element, location);
  }
}

void set_location(DeckTable& table, const Location& location) {
  table.location = location;
  for (auto& entry : table.entries) {
    entry.key_location = location;
    set_location(entry.value, location);
  }
}

const DeckValue* find(const DeckTable& table, std::string_view key) {
  const auto entry = std::ranges::find(table.entries, key, &DeckEntry::key);
  return entry == table.entries.end() ? nullptr : &entry->value;
}

DeckValue* find(DeckTable& table, std::string_view key) {
  const auto entry = std::ranges::find(table.entries, key, &DeckEntry::key);
  return entry == table.entries.end() ? nullptr : &entry->value;
}

std::string joined(const std::string& path, std::string_view key) {
  // As split_path() reads it. The keys of a sweep are paths themselves.
  const bool is_plain = path == "sweep" || key.find_first_of(". ") == std::string_view::npos;
  const auto step = is_plain ? std::string(key) : fmt::format("\"{}\"", key);
  return path.empty() ? step : fmt::format("{}.{}", path, step);
}

std::string element_name(const DeckValue& element, std::size_t index) {
  const auto* table = std::get_if<DeckTable>(&element.content);
  const auto* name = table != nullptr ? find(*table, "name") : nullptr;
  const auto* text = name != nullptr ? std::get_if<std::string>(&name->content) : nullptr;
  return text != nullptr && !text->empty() ? *text : std::to_string(index);
}

Kind kind_of(const DeckValue& value) {
  constexpr std::array kinds{Kind::boolean, Kind::integer, Kind::number, Kind::text,
                             Kind::date,    Kind::array,   Kind::table};
  return kinds[value.content.index()];
}

std::optional<Scalar> scalar_of(const DeckValue& value) {
  switch (kind_of(value)) {
    case Kind::boolean:
      return std::get<bool>(value.content);
    case Kind::integer:
      return std::get<std::int64_t>(value.content);
    case Kind::number:
      return std::get<double>(value.content);
    case Kind::text:
      return std::get<std::string>(value.content);
    default:
      return std::nullopt;
  }
}

std::string content_of(const DeckValue& value) {
  if (const auto scalar = scalar_of(value)) return toml_text(*scalar);
  std::string text;
  if (const auto* array = std::get_if<DeckArray>(&value.content)) {
    for (const auto& element : array->values) text += content_of(element) + ",";
    return "[" + text + "]";
  }
  if (const auto* table = std::get_if<DeckTable>(&value.content)) {
    for (const auto& [key, location, entry] : table->entries) {
      text += fmt::format("{}={},", toml_text(key), content_of(entry));
    }
    return "{" + text + "}";
  }
  return "date";
}

std::vector<std::pair<std::string, std::string>> values_of(const DeckTable& table) {
  ValuesOfDeck values;
  values.add_entries("", table);
  return std::move(values).all();
}

std::string shown(const DeckValue& value) {
  switch (kind_of(value)) {
    case Kind::boolean:
      return fmt::format("{}", std::get<bool>(value.content));
    case Kind::integer:
      return fmt::format("{}", std::get<std::int64_t>(value.content));
    case Kind::number:
      return toml_text(std::get<double>(value.content));
    case Kind::text:
      return fmt::format("\"{}\"", std::get<std::string>(value.content));
    case Kind::date:
      return "a date or time";
    case Kind::array:
      return "an array";
    default:
      return "a table";
  }
}

}  // namespace breccia::detail
