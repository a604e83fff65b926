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

#include "breccia/io/deck_setting.hpp"
#include "breccia/io/range.hpp"
#include "breccia/io/units.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// What the value of a key is.
enum class Kind { absent, boolean, integer, number, text, date, array, table };

/// A word of a choice and what it stands for.
template <class T>
using Choice = std::pair<std::string_view, T>;

namespace detail {
struct DeckTable;
struct DeckState;
struct DeckValue;
}  // namespace detail

/// A table of a deck. A getter reports a missing key or a bad value to the deck, which gathers all mistakes; it then
/// returns a placeholder (NaN, 0, empty), and Deck::finish throws. The `optional_` getters return nothing for a
/// missing key. A section that is missing altogether answers with placeholders and reports nothing more. Every key that
/// was asked for is known; Deck::finish reports all others.
class Section {
 public:
  [[nodiscard]] Kind kind(const std::string& key) const;
  [[nodiscard]] bool has(const std::string& key) const { return kind(key) != Kind::absent; }
  /// All keys, in the order of the deck. They count as known.
  [[nodiscard]] std::vector<std::string> keys() const;
  /// The one of these keys that the section has. Reports it, and returns an empty string, when it has none or several.
  [[nodiscard]] std::string exactly_one(const std::vector<std::string>& keys) const;

  /// A quantity in its SI unit.
  [[nodiscard]] double quantity(const std::string& key, Dimension dimension, const Range& range = {}) const;
  [[nodiscard]] std::optional<double> optional_quantity(const std::string& key, Dimension dimension,
                                                        const Range& range = {}) const;
  [[nodiscard]] std::vector<double> quantities(const std::string& key, Dimension dimension,
                                               const Range& range = {}) const;
  [[nodiscard]] double number(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::optional<double> optional_number(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& key, const Range& range = {}) const;
  /// A share above 0 and below 1, given as a number or in per cent: 0.35 or "35 %".
  [[nodiscard]] double fraction(const std::string& key) const;
  [[nodiscard]] std::int64_t integer(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::optional<std::int64_t> optional_integer(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::vector<std::int64_t> integers(const std::string& key, const Range& range = {}) const;
  [[nodiscard]] std::optional<bool> optional_boolean(const std::string& key) const;
  /// A text that is not empty.
  [[nodiscard]] std::string text(const std::string& key) const;
  [[nodiscard]] std::optional<std::string> optional_text(const std::string& key) const;
  /// A file, named relative to the deck, that must exist.
  [[nodiscard]] std::filesystem::path file(const std::string& key) const;

  /// What one word of a choice stands for.
  template <class T>
  [[nodiscard]] std::optional<T> choice(const std::string& key, const std::vector<Choice<T>>& choices) const {
    const auto index = choice_index(key, words_of(choices));
    return index ? std::optional<T>(choices[*index].second) : std::nullopt;
  }
  /// The same with all words of an enumeration.
  template <HasWords Enum>
  [[nodiscard]] std::optional<Enum> choice(const std::string& key) const {
    return choice<Enum>(key, {words<Enum>.begin(), words<Enum>.end()});
  }
  /// What the words of an array stand for.
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

  /// The elements of an array of numbers, text, true and false.
  [[nodiscard]] std::vector<PlacedScalar> scalars(const std::string& key) const;

  [[nodiscard]] Section section(const std::string& key) const;
  [[nodiscard]] std::optional<Section> optional_section(const std::string& key) const;
  /// The tables of an array of tables.
  [[nodiscard]] std::vector<Section> sections(const std::string& key) const;

  /// Reports a mistake in the value of a key, or in the section when it has no such key.
  void report(const std::string& key, const std::string& message) const;
  /// Runs an action and reports an InputError that it throws, line by line, as a mistake in the value of a key.
  void report_errors_of(const std::string& key, const std::function<void()>& action) const;
  /// Reports keys that make no sense here, if they are present, with the reason.
  void refuse(const std::vector<std::string>& keys, const std::string& reason) const;
  /// Where a key that the section has, and its value, stand.
  [[nodiscard]] Place place_of_key(const std::string& key) const;
  [[nodiscard]] Place place_of_value(const std::string& key) const;
  /// Takes all keys for known: for a section whose meaning cannot be told because of another mistake.
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
  /// Reads a deck and applies overrides `key.path=value`, whose values are TOML or else taken as text. A step of a path
  /// into an array is an index from 0 or, for tables, the `name` of one; the step `*` is every element of an array and
  /// every entry of a table. Throws InputError when there is no such file or it is not TOML, and FileError when it
  /// cannot be read. Overrides that lead nowhere are left to finish().
  explicit Deck(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
  Deck(const Deck&) = delete;
  Deck& operator=(const Deck&) = delete;
  Deck(Deck&&) noexcept;
  Deck& operator=(Deck&&) noexcept;
  ~Deck();

  /// The same deck with nothing asked of it yet, and without the mistakes found so far.
  [[nodiscard]] Deck unread_copy() const;

  /// Replaces or adds a value, before the deck is read, and returns the paths of all that it has replaced: more than
  /// one where the path has a `*`. A path that leads nowhere is a mistake, and returns none.
  std::vector<std::string> set(const Setting& setting);
  /// Adds the entry `key=[...]` of an option to a table at the top, which is made where it is missing. The key is taken
  /// whole, with its dots.
  void add(const std::string& table, const std::string& option, const std::string& entry);

  /// The files that the deck names and that have been asked for so far, in the order of their names.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  [[nodiscard]] const std::filesystem::path& path() const noexcept;
  /// The deck as it stands in the file.
  [[nodiscard]] const std::string& text() const noexcept;
  /// What the deck says, overrides included, but for one key of its top: the same for decks that differ in their
  /// comments and spaces alone.
  [[nodiscard]] std::string content_without(std::string_view key) const;
  /// The same without several keys of its top, and with no more than the first elements of one of its arrays.
  [[nodiscard]] std::string content_with_first(std::size_t count, std::string_view array,
                                               std::span<const std::string_view> left_out) const;
  /// The top of the deck. Sections live as long as the deck.
  [[nodiscard]] Section root() const;
  /// All mistakes found so far, unknown keys of the tables that were looked into included.
  [[nodiscard]] std::vector<Mistake> mistakes() const;
  /// Throws one InputError with all mistakes (refuse_mistakes).
  void finish() const { refuse_mistakes(path(), mistakes()); }

 private:
  explicit Deck(std::unique_ptr<detail::DeckState> state);

  std::unique_ptr<detail::DeckState> state_;
};

}  // namespace breccia
