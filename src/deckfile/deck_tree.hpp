#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "deckfile/deck.hpp"

namespace breccia::detail {

struct DeckEntry;

/// A table, with its entries in the order of the deck.
struct DeckTable {
  Location location;
  std::vector<DeckEntry> entries;
  bool is_inline = false;  ///< whether it is written in braces
};

struct DeckArray {
  std::vector<DeckValue> values;
};

/// A TOML date or time, which no key of a deck takes.
struct Date {};

struct DeckValue {
  Location location;
  std::variant<bool, std::int64_t, double, std::string, Date, DeckArray, DeckTable> content;
};

struct DeckEntry {
  std::string key;
  Location key_location;
  DeckValue value;
};

/// The known keys of a table that was accessed.
struct TableUse {
  std::string path;
  std::set<std::string> asked;
};

struct DeckState {
  std::filesystem::path path;
  std::string text;
  DeckTable root;
  std::map<const DeckTable*, TableUse> uses;
  std::vector<Mistake> mistakes;
  std::vector<std::string> remarks;
  std::vector<UncertainInput> uncertain_inputs;
  std::set<std::filesystem::path> files;  ///< existing files that the deck names
  std::shared_ptr<FileCache> file_cache = std::make_shared<FileCache>();
};

/// Parses a TOML text. Throws InputError, with the location, when it is not TOML.
DeckTable parse_deck(const std::filesystem::path& path, const std::string& text);

/// Gives one location to a value, or to a table with everything in it.
void set_location(DeckValue& value, const Location& location);
void set_location(DeckTable& table, const Location& location);

/// The value of a key, or nullptr.
DeckValue* find(DeckTable& table, std::string_view key);
const DeckValue* find(const DeckTable& table, std::string_view key);

/// The steps of a path, joined: `materials.binder`, `materials."type 2.1"`.
std::string joined(const std::string& path, std::string_view key);

/// The name of an element of an array in a path: that of a table with a `name`, or else its index.
std::string element_name(const DeckValue& element, std::size_t index);

Kind kind_of(const DeckValue& value);

/// The value as a scalar; nothing for an array or a table.
std::optional<Scalar> scalar_of(const DeckValue& value);

/// The text of a value with all its elements, without comments and spaces.
std::string content_of(const DeckValue& value);

/// The paths of all values in a table, with their texts. An array without tables is one value.
std::vector<std::pair<std::string, std::string>> values_of(const DeckTable& table);

/// A value for a message: `"3.6 um"`, `3.6`, `a table`.
std::string shown(const DeckValue& value);

}  // namespace breccia::detail
