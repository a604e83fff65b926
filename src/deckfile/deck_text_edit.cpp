#include "deckfile/deck_text_edit.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "deckfile/deck_text_change.hpp"
#include "deckfile/deck_text_exchange.hpp"
#include "deckfile/deck_text_key.hpp"
#include "deckfile/deck_text_scan.hpp"
#include "deckfile/deck_text_value.hpp"
#include "deckfile/deck_tree_edit.hpp"
#include "io/printable.hpp"

namespace breccia {

namespace {

constexpr auto deck_name = "deck";

void refuse_bad_path(std::span<const DeckStep> path) {
  constexpr std::size_t most_steps = 100;  // each step nests one more table
  if (path.empty() || path.size() > most_steps) {
    throw InputError(fmt::format("expected a path of 1 to {} steps, got {}", most_steps, path.size()));
  }
}

/// What is wrong with a value, without the place in it.
std::string reason_of(const std::string& message) {
  constexpr std::string_view begin = "not TOML: ";
  const auto at = message.find(begin);
  return at == std::string::npos ? message : message.substr(at + begin.size());
}

/// The value without blanks around it. Throws InputError unless it is one value of TOML, without a comment behind it.
std::string single_value(std::span<const DeckStep> path, const std::string& value) {
  const auto refuse = [&](const std::string& reason) {
    throw InputError(fmt::format("{}: expected a value of TOML, such as 0.5 or \"2 mm\", got {}: {}",
                                 detail::path_text(path), printable(value), reason));
  };
  constexpr auto blanks = " \t\r\n";
  const auto begin = value.find_first_not_of(blanks);
  if (begin == std::string::npos) refuse("it is empty");
  auto trimmed = value.substr(begin, value.find_last_not_of(blanks) + 1 - begin);
  try {
    detail::parse_deck("value", fmt::format("value = {}", trimmed));
  } catch (const InputError& error) {
    refuse(reason_of(error.what()));
  }
  if (detail::scanned_value(trimmed).span.end != trimmed.size()) refuse("there is more than a value");
  return trimmed;
}

/// Refuses a key that no TOML can have, such as one with bytes that are not UTF-8.
void refuse_bad_keys(std::span<const DeckStep> path) {
  try {
    detail::parse_deck("path", fmt::format("{} = 0", detail::key_text(path)));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: expected keys of TOML: {}", detail::path_text(path), reason_of(error.what())));
  }
}

detail::DeckTable parsed_result(const std::string& text, std::span<const DeckStep> path) {
  try {
    return detail::parse_deck(deck_name, text);
  } catch (const InputError& error) {
    throw std::logic_error(fmt::format("an edit of {} makes a deck that is {}", detail::path_text(path), error.what()));
  }
}

/// Refuses a result that differs from the tree that the edit is meant to give.
void require_same(const detail::DeckTable& expected, const detail::DeckTable& result, std::span<const DeckStep> path) {
  if (detail::is_same(expected, result)) return;
  throw std::logic_error(fmt::format("an edit of {} changes more or less than this value", detail::path_text(path)));
}

/// Refuses a path that leads to no value of the deck.
void refuse_missing(const detail::DeckTable& root, std::span<const DeckStep> path) {
  refuse_bad_path(path);
  if (detail::present_steps(root, path) == path.size()) return;
  throw InputError(fmt::format("the deck has no {}", detail::path_text(path)));
}

}  // namespace

std::string deck_with_value(const std::string& text, std::span<const DeckStep> path, const std::string& value) {
  refuse_bad_path(path);
  auto expected = detail::parse_deck(deck_name, text);
  detail::present_steps(expected, path);
  refuse_bad_keys(path);
  const auto single = single_value(path, value);
  auto edited = detail::text_with_value(text, path, single);
  detail::assign(expected, path, detail::tree_of(single));
  require_same(expected, parsed_result(edited, path), path);
  return edited;
}

std::string deck_without(const std::string& text, std::span<const DeckStep> path) {
  refuse_bad_path(path);
  auto expected = detail::parse_deck(deck_name, text);
  if (detail::present_steps(expected, path) < path.size()) {
    throw InputError(fmt::format("nothing to remove: the deck has no {}", detail::path_text(path)));
  }
  auto edited = detail::text_without(text, path);
  const auto result = parsed_result(edited, path);
  detail::erase(expected, path);
  // Tables and arrays that only had this value may be gone with it, if they had no header.
  for (auto around = path.first(path.size() - 1); !around.empty(); around = around.first(around.size() - 1)) {
    if (detail::value_at(result, around) != nullptr) break;
    if (!detail::is_empty(*detail::value_at(expected, around))) break;
    detail::erase(expected, around);
  }
  require_same(expected, result, path);
  return edited;
}

std::string deck_with_key(const std::string& text, std::span<const DeckStep> path, const std::string& key) {
  auto expected = detail::parse_deck(deck_name, text);
  refuse_missing(expected, path);
  if (path.back() == DeckStep(key)) return text;
  if (!std::holds_alternative<std::string>(path.back())) {
    throw InputError(fmt::format("{} is an element of an array: it has no key", detail::path_text(path)));
  }
  const auto renamed = detail::extended(path.first(path.size() - 1), DeckStep(key));
  if (detail::value_at(expected, renamed) != nullptr) {
    throw InputError(fmt::format("the deck has a {} already", detail::path_text(renamed)));
  }
  refuse_bad_keys(renamed);
  auto edited = detail::text_with_key(text, path, key);
  detail::rename(expected, path, key);
  require_same(expected, parsed_result(edited, path), path);
  return edited;
}

std::string deck_with_exchange(const std::string& text, std::span<const DeckStep> one,
                               std::span<const DeckStep> other) {
  auto expected = detail::parse_deck(deck_name, text);
  refuse_missing(expected, one);
  refuse_missing(expected, other);
  const auto around = one.first(one.size() - 1);
  if (one.size() != other.size() || !detail::is_within(other, around) || one.back() == other.back()) {
    throw InputError(fmt::format("{} and {} cannot change places: they are not two of one table or array",
                                 detail::path_text(one), detail::path_text(other)));
  }
  auto edited = detail::text_with_exchange(text, one, other);
  detail::exchange(expected, one, other);
  require_same(expected, parsed_result(edited, one), one);
  return edited;
}

}  // namespace breccia
