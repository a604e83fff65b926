#include "deckfile/deck_text_addition.hpp"

#include <algorithm>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deckfile/deck_text_items.hpp"
#include "deckfile/deck_text_lines.hpp"
#include "deckfile/deck_text_place.hpp"
#include "deckfile/deck_text_value.hpp"
#include "io/printable.hpp"

namespace breccia::detail {

namespace {

bool is_key(const DeckStep& step) {
  return std::holds_alternative<std::string>(step);
}

/// Adds the first missing step of a path, with a value that has all others.
class Addition {
 public:
  Addition(const DeckSource& source, DeckSteps path, std::size_t present, const std::string& value)
      : source_(source),
        present_(path.first(present)),
        missing_(path.subspan(present)),
        value_(value),
        first_value_(wrapped(missing_.subspan(1), value)) {}

  [[nodiscard]] std::string result() const {
    if (const auto* line = line_of_value(source_, present_)) return in_line(place_in_line(*line, present_));
    if (!is_key(missing_.front())) return with_last_block(next_element());
    if (const auto entry = last_dotted_entry(source_, present_)) return with_dotted_entry(*entry);
    const auto block = missing_block();
    return block.empty() || has_tables_in_braces() ? with_entry() : with_last_block(block);
  }

 private:
  /// `key = value` for what is missing in a table, with the steps to the table if its keys are dotted.
  [[nodiscard]] EntryText entry_after(DeckSteps dotted) const {
    return {extended(dotted, missing_.front()), first_value_};
  }

  [[nodiscard]] std::string in_line(const ItemPlace& place) const {
    const auto entry = text_of(entry_after(place.dotted));
    if (place.value == nullptr) {
      return with_braced_entry_after(source_.text, place.container->items[place.items.back()], entry);
    }
    if (place.value->form == SourceValue::Form::array) return with_element(source_.text, *place.value, first_value_);
    return with_braced_entry(source_.text, *place.value, entry);
  }

  /// The block of one more element of the array of tables in blocks to which the path leads.
  [[nodiscard]] std::vector<std::string> next_element() const {
    if (!is_in_braces(first_value_)) {
      throw InputError(fmt::format("{}: expected a table, since {} is an array of [[tables]], got {}",
                                   path_text(extended(present_, missing_.front())), path_text(present_),
                                   printable(first_value_)));
    }
    return element_block(present_, entries_of(first_value_));
  }

  /// The block of the table or of the array of tables that is missing; nothing for a value in a line.
  [[nodiscard]] std::vector<std::string> missing_block() const {
    const auto index = std::ranges::find_if_not(missing_, is_key);
    const auto keys = missing_.first(static_cast<std::size_t>(index - missing_.begin()));
    const auto rest = missing_.subspan(keys.size());
    if (!rest.empty()) {
      const auto element = wrapped(rest.subspan(1), value_);
      if (is_in_braces(element)) return element_block(extended(present_, keys), entries_of(element));
    }
    const auto value = wrapped(rest, value_);
    if (is_in_braces(value)) return table_block(extended(present_, keys), entries_of(value));
    if (keys.size() == 1) return {};
    return table_block(extended(present_, keys.first(keys.size() - 1)), {{DeckPath{keys.back()}, value}});
  }

  /// Whether the tables in the table to which the path leads are in braces, at least one of them, and none is a block.
  [[nodiscard]] bool has_tables_in_braces() const {
    const auto is_block_within = [&](const DeckStatement& one) {
      return one.form != DeckStatement::Form::entry && is_within(one.path, present_) &&
             one.path.size() > present_.size();
    };
    const auto is_table_in_braces = [&](const DeckStatement& one) {
      return is_within(one.section, present_) && one.entry.value.form == SourceValue::Form::table;
    };
    return !present_.empty() && std::ranges::none_of(source_.statements, is_block_within) &&
           std::ranges::any_of(source_.statements, is_table_in_braces);
  }

  [[nodiscard]] std::string with_dotted_entry(std::size_t last) const {
    return with_entry_after(source_, last, entry_after(present_.subspan(source_.statements[last].section.size())));
  }

  /// A line at the end of the entries of the table.
  [[nodiscard]] std::string with_entry() const {
    const auto entry = entry_after({});
    if (const auto last = last_entry(source_, present_)) return with_entry_after(source_, *last, entry);
    const auto line = text_of(entry);
    if (const auto header = header_of(source_, present_)) {
      return with_lines(source_.text, source_.statements[*header].lines.end, {line});
    }
    const auto next_block = first_within(source_, present_);
    const auto at = next_block ? block_begin(source_, *next_block) : source_.text.size();
    if (!present_.empty()) return with_block(source_.text, at, table_block(present_, {entry}));
    return next_block ? with_block(source_.text, at, {line}) : with_lines(source_.text, at, {line});
  }

  /// The block after all blocks of the table or the array.
  [[nodiscard]] std::string with_last_block(const std::vector<std::string>& block) const {
    const auto last = last_within(source_, present_);
    const auto at = present_.empty() || !last ? source_.text.size() : block_end(source_, *last);
    return with_block(source_.text, at, block);
  }

  const DeckSource& source_;
  DeckSteps present_;
  DeckSteps missing_;
  const std::string& value_;
  std::string first_value_;  ///< of the first missing step
};

}  // namespace

std::string text_with_addition(const DeckSource& source, DeckSteps path, std::size_t present,
                               const std::string& value) {
  return Addition(source, path, present, value).result();
}

}  // namespace breccia::detail
