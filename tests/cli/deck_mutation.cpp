#include "deck_mutation.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace breccia::test {

namespace {

using Random = std::mt19937_64;

/// A part of a text.
struct Part {
  std::size_t begin = 0, size = 0;
};

std::size_t below(std::size_t bound, Random& random) {
  return static_cast<std::size_t>(random() % bound);
}

template <class T>
const T& one_of(const std::vector<T>& all, Random& random) {
  return all[below(all.size(), random)];
}

/// The longest parts whose letters are all of one kind.
template <class IsLetter>
std::vector<Part> parts(std::string_view text, const IsLetter& is_letter) {
  std::vector<Part> found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_letter(text[i])) continue;
    const bool goes_on = !found.empty() && found.back().begin + found.back().size == i;
    if (!goes_on) found.push_back({i, 0});
    ++found.back().size;
  }
  return found;
}

bool is_of_word(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

std::vector<Part> keys(std::string_view deck) {
  auto words = parts(deck, is_of_word);
  std::erase_if(words, [&](const Part& word) {
    const auto next = deck.find_first_not_of(' ', word.begin + word.size);
    return next == std::string_view::npos || deck[next] != '=';
  });
  return words;
}

std::vector<Part> numbers(std::string_view deck) {
  auto all =
      parts(deck, [](char letter) { return std::string_view("0123456789.").find(letter) != std::string_view::npos; });
  std::erase_if(all, [&](const Part& number) { return number.begin > 0 && is_of_word(deck[number.begin - 1]); });
  return all;
}

/// The quoted texts of a deck, with their quotes.
std::vector<Part> texts(std::string_view deck) {
  std::vector<Part> found;
  for (auto begin = deck.find('"'); begin != std::string_view::npos;) {
    const auto end = deck.find('"', begin + 1);
    if (end == std::string_view::npos) break;
    found.push_back({begin, end + 1 - begin});
    begin = deck.find('"', end + 1);
  }
  return found;
}

std::vector<Part> lines(std::string_view deck) {
  auto all = parts(deck, [](char letter) { return letter != '\n'; });
  for (auto& line : all) ++line.size;  // including the end of the line
  return all;
}

/// A deck with another text in place of one of the parts.
std::string replace_one(std::string deck, const std::vector<Part>& parts, const std::vector<std::string>& by,
                        Random& random) {
  if (parts.empty()) return deck;
  const auto [begin, size] = one_of(parts, random);
  return deck.replace(begin, size, one_of(by, random));
}

std::string misspell_key(std::string deck, Random& random) {
  const auto [begin, size] = one_of(keys(deck), random);
  const auto at = begin + below(size, random);
  switch (below(3, random)) {
    case 0:
      return deck.erase(at, 1);
    case 1:
      return deck.insert(at, 1, deck[at]);
    default:
      std::swap(deck[at], deck[begin]);
      return deck;
  }
}

std::string change_type(std::string deck, Random& random) {
  const auto values = texts(deck);
  return replace_one(std::move(deck), values,
                     {"7", "-0.5", "true", "[]", "[1, \"2\"]", "{ a = 1 }", "1979-05-27", "\"\"", "\"x\""}, random);
}

std::string change_unit(std::string deck, Random& random) {
  auto units = texts(deck);
  for (auto& [begin, size] : units) {
    const auto space = deck.find(' ', begin);
    const auto end = begin + size - 1;
    begin = std::min(space, end);
    size = end - begin;
  }
  std::erase_if(units, [](const Part& unit) { return unit.size == 0; });
  return replace_one(std::move(deck), units, {"", " GPa", " furlong", " s", " um", " Pa s", " g/cm^3", " /", " m^m"},
                     random);
}

std::string change_sign(std::string deck, Random& random) {
  auto before = numbers(deck);
  for (auto& number : before) number.size = 0;
  return replace_one(std::move(deck), before, {"-"}, random);
}

template <class... Values>
std::string change_number(std::string deck, Random& random, Values... values) {
  const auto found = numbers(deck);
  return replace_one(std::move(deck), found, {values...}, random);
}

std::string repeat_line(std::string deck, Random& random) {
  const auto [begin, size] = one_of(lines(deck), random);
  return deck.insert(begin, deck.substr(begin, size));
}

std::string remove_line(std::string deck, Random& random) {
  const auto all = lines(deck);
  return replace_one(std::move(deck), all, {""}, random);
}

std::string remove_section(std::string deck, Random& random) {
  std::vector<Part> sections;
  for (std::size_t begin = deck.find("\n["); begin != std::string::npos;) {
    const auto end = std::min(deck.find("\n[", begin + 1), deck.size());
    sections.push_back({begin, end - begin});
    begin = deck.find("\n[", end);
  }
  return replace_one(std::move(deck), sections, {"\n"}, random);
}

std::string change_bracket(std::string deck, Random& random) {
  const auto brackets = parts(deck, [](char letter) { return std::string_view("[]{}").find(letter) < 4; });
  return replace_one(std::move(deck), brackets, {"", "[", "]", "{", "}", "[["}, random);
}

std::string change_file(std::string deck, Random& random) {
  auto files = texts(deck);
  std::erase_if(files, [&](const Part& text) { return !deck.substr(text.begin, text.size).ends_with(".csv\""); });
  return replace_one(std::move(deck), files,
                     {"\"none.csv\"", "\"binder.csv\"", "\"sizes.csv\"", "\"discs.csv\"", "\"measured.csv\"", "\".\"",
                      "\"deck.toml\"", "\"\"", "\"/dev/null\""},
                     random);
}

std::string swap_lines(std::string deck, Random& random) {
  const auto all = lines(deck);
  auto first = one_of(all, random), second = one_of(all, random);
  if (first.begin == second.begin) return deck;
  if (second.begin < first.begin) std::swap(first, second);
  const auto later = deck.substr(second.begin, second.size);
  deck.replace(second.begin, second.size, deck.substr(first.begin, first.size));
  return deck.replace(first.begin, first.size, later);
}

std::string flip_bits(std::string deck, Random& random) {
  for (std::size_t i = 0; i < 3; ++i) {
    auto& letter = deck[below(deck.size(), random)];
    letter = static_cast<char>(static_cast<unsigned char>(letter) ^ (1U << below(7, random)));
  }
  return deck;
}

std::string insert_foreign_bytes(std::string deck, Random& random) {
  const std::vector<std::string> foreign = {"\xff", "\xc3", "\xe9", "\xc3\xa9", "\xe2\x80\x8b", std::string(1, '\0')};
  return deck.insert(below(deck.size(), random), one_of(foreign, random));
}

}  // namespace

const std::vector<DeckMutation>& deck_mutations() {
  static const std::vector<DeckMutation> all = {
      {"key misspelt", misspell_key},
      {"wrong type", change_type},
      {"wrong unit", change_unit},
      {"wrong sign", change_sign},
      {"zero", [](std::string deck, Random& random) { return change_number(std::move(deck), random, "0", "0.0"); }},
      {"huge",
       [](std::string deck, Random& random) {
         return change_number(std::move(deck), random, "1e300", "123456789", "1e12", "9223372036854775807");
       }},
      {"tiny",
       [](std::string deck, Random& random) { return change_number(std::move(deck), random, "1e-300", "1e-9"); }},
      {"not a number",
       [](std::string deck, Random& random) { return change_number(std::move(deck), random, "nan", "inf"); }},
      {"line repeated", repeat_line},
      {"line removed", remove_line},
      {"section removed", remove_section},
      {"wrong bracket", change_bracket},
      {"wrong file", change_file},
      {"lines swapped", swap_lines},
      {"bits flipped", flip_bits},
      {"foreign bytes", insert_foreign_bytes},
  };
  return all;
}

}  // namespace breccia::test
