// Edits of the text of a deck: a line with the path, its steps parted by "|", a line with the value, empty to remove
// what is there, and the deck. An edit that changes anything else ends in std::logic_error, which is no refusal.

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "deckfile/deck_text_edit.hpp"
#include "input_folder.hpp"
#include "io/safe_name.hpp"
#include "refusal.hpp"

namespace {

/// The steps of a path: numbers are indices.
std::vector<breccia::DeckStep> path_of(const std::string& line) {
  constexpr std::size_t longest_index = 6;
  std::vector<breccia::DeckStep> path;
  std::istringstream steps(line);
  for (std::string step; std::getline(steps, step, '|');) {
    if (breccia::is_count(step) && step.size() <= longest_index) {
      path.emplace_back(std::stoul(step));
    } else {
      path.emplace_back(step);
    }
  }
  return path;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  // NOLINT(*-naming)
  using namespace breccia;
  std::istringstream lines{std::string(fuzz::text_of(data, size))};
  std::string path, value, deck;
  std::getline(lines, path);
  std::getline(lines, value);
  std::getline(lines, deck, '\0');
  fuzz::allow_refusal([&] {
    const auto steps = path_of(path);
    static_cast<void>(value.empty() ? deck_without(deck, steps) : deck_with_value(deck, steps, value));
  });
  return 0;
}
