#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "breccia/deckfile/deck_setting.hpp"
#include "breccia/deckfile/uncertain_input.hpp"
#include "breccia/words.hpp"

#include "io/file_cache.hpp"
#include "io/range.hpp"
#include "io/units.hpp"

namespace breccia {

/// The type of the value of a key.
enum class Kind { absent, boolean, integer, number, text, date, array, table };

struct NumberReader;

/// A word that a key accepts, and its value.
template <class T>
using Choice = std::pair<std::string_view, T>;

namespace detail {
struct DeckTable;
struct DeckState;
struct DeckValue;
}  // namespace detail

/// A table of a deck. A getter reports a missing key or a bad value to the deck, which collects all mistakes; it then
/// returns a placeholder (NaN, 0, empty), and Deck::finish() throws. The `optional_` getters return nothing for a
/// missing key. The getters of a missing section return placeholders without further reports. Every key that a getter
/// was called for is known; Deck::finish() reports all other keys as unknown.
///
/// Any single number may be a distribution, `{ value = "5.8 GPa", sd = "0.6 GPa" }` (read_distribution): its getter
/// returns the median. Any value may be one of several, `{ any = [1, 2, 3] }`: all functions take the first in its
/// place. The deck remembers both (Deck::uncertain_inputs).
class Section {
 public:
  [[nodiscard]] Kind kind(const std::string& key) const;
  [[nodiscard]] bool has(const std::string& key) const { return kind(key) != Kind::absent; }
  /// Whether the value of a key is a distribution.
  [[nodiscard]] bool is_distribution(const std::string& key) const;
  /// Returns all keys, in the order of the deck, and marks them as known.
  [[nodiscard]] std::vector<std::string> keys() const;
  /// The one key among these that the section has. If it has none or several of them, reports that and returns an empty
  /// string.
  [[nodiscard]] std::string exactly_one(const std::vector<std::string>& keys) const;

  /// The value of a quantity in its SI unit.
  [[nodiscard]] double quantity(const std::string& key, Dimension dimension, const Range& range = {}) const;
  [[nodiscard]] std::optional<double> optional_quantity(const std::string& key, Dimension dimension,
                                                        const Range& range = {}) const;
  [[nodiscard]] std::vector<double> quantities(const std::string& key, Dimension dimension,
                                               const Range& range = {}) const;
  [[nodiscard]] double number(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::optional<double> optional_number(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& key, const Range& range = {}) const;
  /// A fraction, given as a number or in per cent: 0.35 or "35 %".
  [[nodiscard]] double fraction(const std::string& key, const Range& range = Range::between(0.0, 1.0)) const;
  [[nodiscard]] std::int64_t integer(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::optional<std::int64_t> optional_integer(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::vector<std::int64_t> integers(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::optional<bool> optional_boolean(const std::string& key) const;
  /// A text that is not empty.
  [[nodiscard]] std::string text(const std::string& key) const;
  [[nodiscard]] std::optional<std::string> optional_text(const std::string& key) const;
  /// The path of a file, which the deck names relative to itself. Reports a file that does not exist.
  [[nodiscard]] std::filesystem::path file(const std::string& key) const;
  /// The path of a file whose name is a part of the value of an existing key.
  [[nodiscard]] std::filesystem::path file(const std::string& key, const std::string& name) const;

  /// The cache of objects that have been made from the files of the deck so far.
  [[nodiscard]] FileCache& file_cache() const;

  /// The value of the word that a key has.
  template <class T>
  [[nodiscard]] std::optional<T> choice(const std::string& key, const std::vector<Choice<T>>& choices) const {
    const auto index = choice_index(key, words_of(choices));
    return index ? std::optional<T>(choices[*index].second) : std::nullopt;
  }
  /// The value of an enumeration whose word a key has.
  template <HasWords Enum>
  [[nodiscard]] std::optional<Enum> choice(const std::string& key) const {
    return choice<Enum>(key, {words<Enum>.begin(), words<Enum>.end()});
  }
  /// The values of the words in an array.
  template <class T>
  [[nodiscard]] std::vector<T> list_of_choices(const std::string& key, const std::vector<Choice<T>>& choices) const {
    std::vector<T> chosen;
    for (const auto index : choice_indices(key, words_of(choices))) chosen.push_back(choices[index].second);
    return chosen;
  }
  template <HasWords Enum>
  [[nodiscard]] std::vector<Enum> list_of_choices(const std::string& key) const {
    return list_of_choices<Enum>(key, {words<Enum>.begin(), words<Enum>.end()});
  }

  /// The elements of an array of numbers, texts and booleans.
  [[nodiscard]] std::vector<LocatedScalar> scalars(const std::string& key) const;

  [[nodiscard]] Section section(const std::string& key) const;
  [[nodiscard]] std::optional<Section> optional_section(const std::string& key) const;
  /// The tables of an array of tables.
  [[nodiscard]] std::vector<Section> sections(const std::string& key) const;

  /// Reports a mistake in the value of a key, or in the section when it has no such key.
  void report(const std::string& key, const std::string& message) const;
  /// Records how an ambiguous value of an existing key was read, in words that begin with its path: what is no mistake,
  /// but the reader of the deck has to know.
  void remark(const std::string& key, const std::string& message) const;
  /// Runs an action. If it throws InputError, reports each line of the message as a mistake in the value of a key.
  void report_errors_of(const std::string& key, const std::function<void()>& action) const;
  /// Reports those of these keys that are present: they are not allowed here, for the reason given.
  void refuse(const std::vector<std::string>& keys, const std::string& reason) const;
  /// Location of an existing key.
  [[nodiscard]] Location location_of_key(const std::string& key) const;
  /// Location of the value of an existing key.
  [[nodiscard]] Location location_of_value(const std::string& key) const;
  /// Marks all keys as known: for a section that cannot be interpreted because of another mistake.
  void accept_all_keys() const { static_cast<void>(keys()); }

 private:
  friend class Deck;
  Section(detail::DeckState& state, const detail::DeckTable* table, std::string path);

  template <class T>
  static std::vector<std::string> words_of(const std::vector<Choice<T>>& choices) {
    std::vector<std::string> all;
    all.reserve(choices.size());
    for (const auto& [word, meaning] : choices) all.emplace_back(word);
    return all;
  }
  [[nodiscard]] std::optional<std::size_t> choice_index(const std::string& key,
                                                        const std::vector<std::string>& words) const;
  [[nodiscard]] std::vector<std::size_t> choice_indices(const std::string& key,
                                                        const std::vector<std::string>& words) const;

  [[nodiscard]] const detail::DeckValue* find(const std::string& key) const;
  [[nodiscard]] const detail::DeckValue& first_choice(const std::string& key, const detail::DeckValue& value) const;
  [[nodiscard]] std::optional<double> median(const std::string& key, const NumberReader& reader, const Range& range,
                                             std::string_view unit) const;
  [[nodiscard]] const detail::DeckValue* require(const std::string& key, const std::string& expected) const;
  [[nodiscard]] std::string path_of(const std::string& key) const;
  template <class Read>
  auto elements(const std::string& key, const std::string& expected, const Read& read) const;

  detail::DeckState* state_;
  const detail::DeckTable* table_;  ///< null when the section is missing
  std::string path_;
};

/// A TOML file with overrides.
class Deck {
 public:
  /// Reads a deck and applies overrides `key.path=value`. A value that is not TOML is taken as text. A step of a path
  /// that selects an element of an array is its index from 0 or, for tables, its `name`; the step `*` stands for every
  /// element of an array and every entry of a table. Throws InputError when the file does not exist or is not TOML, and
  /// FileError when it cannot be read. Overrides whose path does not exist are reported by finish().
  explicit Deck(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                const ValueOrigins& origins = {});
  /// A deck that a program has written: its text, its name in messages, and the directory to which its file names are
  /// relative. A mistake is reported with the name instead of line and column. Throws InputError when the text is not
  /// TOML.
  static Deck from_text(const std::string& text, const std::string& name, const std::filesystem::path& directory,
                        const std::vector<std::string>& overrides = {}, const ValueOrigins& origins = {});
  Deck(const Deck&) = delete;
  Deck& operator=(const Deck&) = delete;
  Deck(Deck&&) noexcept;
  Deck& operator=(Deck&&) noexcept;
  ~Deck();

  /// A copy of the deck in which no key is known yet and no mistake has been reported. It shares the FileCache.
  [[nodiscard]] Deck unread_copy() const;

  /// Replaces or adds a value, before the deck is read. Returns the paths of all values that it has set: several if the
  /// path has a `*`. Reports a path that does not exist as a mistake and returns an empty list.
  std::vector<std::string> set(const Setting& setting);
  /// Adds the entry `key=[...]` of a command-line option to a table at the top of the deck, which is created if it is
  /// missing. Dots in the key are part of its name.
  void add(const std::string& table, const std::string& option, const std::string& entry);

  /// The files that have been read through Section::file() so far, in alphabetical order.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  [[nodiscard]] const std::filesystem::path& path() const noexcept;
  /// The text of the file.
  [[nodiscard]] const std::string& text() const noexcept;
  /// The content of the deck, overrides included, without one of its top-level keys. Decks that differ only in comments
  /// and spaces have the same content.
  [[nodiscard]] std::string content_without(std::string_view key) const;
  /// The content without several top-level keys, and with only the first `count` elements of one top-level array.
  [[nodiscard]] std::string content_with_first(std::size_t count, std::string_view array,
                                               std::span<const std::string_view> left_out) const;
  /// The paths of all values, overrides included, with their texts, in the order of the deck: `stages.composite.cells`,
  /// `60`. An array without tables is one value.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> values() const;
  /// The top-level table. Sections are valid as long as the deck exists.
  [[nodiscard]] Section root() const;
  /// All mistakes found so far, including the unknown keys of all tables that were accessed.
  [[nodiscard]] std::vector<Mistake> mistakes() const;
  /// The readings of ambiguous values so far (Section::remark).
  [[nodiscard]] const std::vector<std::string>& remarks() const noexcept;
  /// The inputs that are not certain, as far as they were read, in the order in which they were read.
  [[nodiscard]] const std::vector<UncertainInput>& uncertain_inputs() const noexcept;
  /// Throws one InputError with all mistakes (refuse_mistakes).
  void finish() const { refuse_mistakes(path(), mistakes()); }

 private:
  explicit Deck(std::unique_ptr<detail::DeckState> state);

  std::unique_ptr<detail::DeckState> state_;
};

}  // namespace breccia
