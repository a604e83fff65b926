#include "deckfile/deck.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deckfile/deck_override.hpp"
#include "deckfile/deck_tree.hpp"
#include "io/nearest_name.hpp"
#include "io/text_encoding.hpp"
#include "io/text_file.hpp"

namespace breccia {

using detail::DeckState;

namespace {

void add_unknown_keys(const DeckState& state, std::vector<Mistake>& mistakes) {
  for (const auto& [table, use] : state.uses) {
    const std::vector<std::string> known(use.asked.begin(), use.asked.end());
    for (const auto& entry : table->entries) {
      if (use.asked.contains(entry.key)) continue;
      const auto where = use.path.empty() ? "" : use.path + ": ";
      mistakes.push_back(
          {entry.key_location, fmt::format("{}unknown key \"{}\"{}", where, entry.key, suggestion(entry.key, known))});
    }
  }
}

}  // namespace

Deck::Deck(const std::filesystem::path& path, const std::vector<std::string>& overrides, const ValueOrigins& origins)
    : state_(std::make_unique<DeckState>()) {
  std::error_code is_no_name_of_a_file;  // too long, for example
  if (!std::filesystem::exists(path, is_no_name_of_a_file))
    throw InputError(fmt::format("{}: no such deck", path.string()));
  if (std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("{}: expected a deck, got a directory", path.string()));
  }
  state_->path = path;
  state_->text = read_text(path);
  detail::refuse_binary(path, state_->text);
  detail::require_utf8(path, state_->text);
  state_->root = detail::parse_deck(path, state_->text);
  for (const auto& text : overrides) {
    detail::apply_override(state_->root, origins.overrides, text, state_->mistakes);
  }
}

Deck Deck::from_text(const std::string& text, const std::string& name, const std::filesystem::path& directory,
                     const std::vector<std::string>& overrides, const ValueOrigins& origins) {
  auto state = std::make_unique<DeckState>();
  state->path = directory / name;
  state->text = text;
  detail::require_utf8(name, text);
  state->root = detail::parse_deck(name, text);
  detail::set_location(state->root, {.option = name});
  for (const auto& entry : overrides) {
    detail::apply_override(state->root, origins.overrides, entry, state->mistakes);
  }
  return Deck(std::move(state));
}

Deck::Deck(std::unique_ptr<DeckState> state) : state_(std::move(state)) {}
Deck::Deck(Deck&&) noexcept = default;
Deck& Deck::operator=(Deck&&) noexcept = default;
Deck::~Deck() = default;

const std::string& Deck::text() const noexcept {
  return state_->text;
}

Deck Deck::unread_copy() const {
  auto state = std::make_unique<DeckState>();
  state->path = state_->path;
  state->text = state_->text;
  state->root = state_->root;
  state->file_cache = state_->file_cache;
  return Deck(std::move(state));
}

std::vector<std::string> Deck::set(const Setting& setting) {
  return detail::apply_setting(state_->root, setting, state_->mistakes);
}

void Deck::add(const std::string& table, const std::string& option, const std::string& entry) {
  detail::add_entry(state_->root, table, {fmt::format("{} {}", option, entry)}, entry, state_->mistakes);
}

const std::filesystem::path& Deck::path() const noexcept {
  return state_->path;
}

std::string Deck::content_without(std::string_view key) const {
  auto root = state_->root;
  std::erase_if(root.entries, [&](const detail::DeckEntry& entry) { return entry.key == key; });
  return detail::content_of({{}, std::move(root)});
}

std::string Deck::content_with_first(std::size_t count, std::string_view array,
                                     std::span<const std::string_view> left_out) const {
  auto root = state_->root;
  std::erase_if(root.entries, [&](const detail::DeckEntry& entry) {
    return std::ranges::find(left_out, entry.key) != left_out.end();
  });
  if (auto* found = detail::find(root, array)) {
    auto* elements = std::get_if<detail::DeckArray>(&found->content);
    if (elements != nullptr && elements->values.size() > count) elements->values.resize(count);
  }
  return detail::content_of({{}, std::move(root)});
}

std::vector<std::pair<std::string, std::string>> Deck::values() const {
  return detail::values_of(state_->root);
}

std::vector<std::filesystem::path> Deck::files() const {
  return {state_->files.begin(), state_->files.end()};
}

Section Deck::root() const {
  return {*state_, &state_->root, ""};
}

const std::vector<std::string>& Deck::remarks() const noexcept {
  return state_->remarks;
}

const std::vector<UncertainInput>& Deck::uncertain_inputs() const noexcept {
  return state_->uncertain_inputs;
}

std::vector<Mistake> Deck::mistakes() const {
  auto mistakes = state_->mistakes;
  add_unknown_keys(*state_, mistakes);
  return mistakes;
}

}  // namespace breccia
