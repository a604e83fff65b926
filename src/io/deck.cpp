#include "breccia/io/deck.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/io/nearest_name.hpp"
#include "breccia/io/text_file.hpp"

#include "deck_tree.hpp"

namespace breccia {

using detail::DeckState;
using detail::Mistake;

namespace {

void add_unknown_keys(const DeckState& state, std::vector<Mistake>& mistakes) {
  for (const auto& [table, use] : state.uses) {
    const std::vector<std::string> known(use.asked.begin(), use.asked.end());
    for (const auto& entry : table->entries) {
      if (use.asked.contains(entry.key)) continue;
      const auto where = use.path.empty() ? "" : use.path + ": ";
      mistakes.push_back(
          {entry.key_place, fmt::format("{}unknown key \"{}\"{}", where, entry.key, suggestion(entry.key, known))});
    }
  }
}

std::string line_of(const DeckState& state, const Mistake& mistake) {
  const auto& place = mistake.place;
  if (!place.override_text.empty()) return fmt::format("{}: {}", place.override_text, mistake.message);
  return fmt::format("{}:{}:{}: {}", state.path.string(), place.line, place.column, mistake.message);
}

}  // namespace

Deck::Deck(const std::filesystem::path& path, const std::vector<std::string>& overrides)
    : state_(std::make_unique<DeckState>()) {
  if (!std::filesystem::exists(path)) throw InputError(fmt::format("{}: no such deck", path.string()));
  if (std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("{}: expected a deck, got a directory", path.string()));
  }
  state_->path = path;
  state_->text = read_text(path);
  state_->root = detail::parse_deck(path, state_->text);
  for (const auto& text : overrides) detail::apply_override(state_->root, text, state_->mistakes);
}

Deck::Deck(Deck&&) noexcept = default;
Deck& Deck::operator=(Deck&&) noexcept = default;
Deck::~Deck() = default;

const std::string& Deck::text() const noexcept {
  return state_->text;
}

std::vector<std::filesystem::path> Deck::files() const {
  return {state_->files.begin(), state_->files.end()};
}

Section Deck::root() const {
  return {*state_, &state_->root, ""};
}

void Deck::finish() const {
  auto mistakes = state_->mistakes;
  add_unknown_keys(*state_, mistakes);
  if (mistakes.empty()) return;
  std::ranges::stable_sort(mistakes, {}, [](const Mistake& mistake) {
    const auto& place = mistake.place;
    return std::tuple(!place.override_text.empty(), place.line, place.column);
  });
  std::vector<std::string> lines;
  for (const auto& mistake : mistakes) {
    auto line = line_of(*state_, mistake);
    if (lines.empty() || lines.back() != line) lines.push_back(std::move(line));
  }
  throw InputError(fmt::format("{}", fmt::join(lines, "\n")));
}

}  // namespace breccia
