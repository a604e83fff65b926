#include "deckfile/deck_text_key.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

#include "deckfile/deck_text_place.hpp"
#include "deckfile/deck_text_scan.hpp"

namespace breccia::detail {

namespace {

/// Collects the places in a text where the last key of a path is written.
class KeyPlaces {
 public:
  explicit KeyPlaces(DeckSteps path) : path_(path) {}

  void add(const DeckStatement& statement) {
    if (statement.form == DeckStatement::Form::entry) {
      const bool can_have_it = path_.size() > statement.section.size() && is_within(path_, statement.section);
      if (can_have_it) add(statement.entry, path_.subspan(statement.section.size()));
    } else if (is_within(statement.path, path_)) {
      // The indices of a path are not written in a header.
      const auto is_key = [](const DeckStep& step) { return std::holds_alternative<std::string>(step); };
      const auto keys = static_cast<std::size_t>(std::ranges::count_if(path_, is_key));
      places_.push_back(statement.header_spans[keys - 1]);
    }
  }

  /// The places in the order of the text.
  [[nodiscard]] const std::vector<TextSpan>& all() const { return places_; }

 private:
  /// `rest`: the steps of the path from the table in which the item is.
  void add(const SourceItem& item, DeckSteps rest) {
    if (common_steps(item, rest) == 0) return;
    if (rest.size() <= item.keys.size()) {
      places_.push_back(item.key_spans[rest.size() - 1]);
    } else {
      add(item.value, rest.subspan(item.keys.size()));
    }
  }

  void add(const SourceValue& value, DeckSteps rest) {
    if (const auto* index = std::get_if<std::size_t>(&rest.front())) {
      add(value.items.at(*index).value, rest.subspan(1));
      return;
    }
    for (const auto& item : value.items) add(item, rest);
  }

  DeckSteps path_;
  std::vector<TextSpan> places_;
};

}  // namespace

std::string text_with_key(const std::string& text, DeckSteps path, const std::string& key) {
  const auto source = scanned(text);
  KeyPlaces places(path);
  for (const auto& statement : source.statements) places.add(statement);
  const DeckStep step = key;
  const auto written = key_text({&step, 1});
  auto result = text;
  for (auto i = places.all().size(); i-- > 0;) {
    const auto& span = places.all()[i];
    result.replace(span.begin, span.end - span.begin, written);
  }
  return result;
}

}  // namespace breccia::detail
