#include <filesystem>

#include <gtest/gtest.h>

#include "decks.hpp"
#include "io/text_file.hpp"

namespace breccia {
namespace {

const std::filesystem::path documentation = BRECCIA_DOCUMENTATION_DIRECTORY;

/// The first TOML example of a page.
std::string first_deck(const std::string& page) {
  const std::string fence = "```toml\n";
  const auto begin = page.find(fence) + fence.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

TEST(Documentation, ItsDeckIsOne) {
  const test::DeckDirectory directory;
  const auto data = (documentation / ".." / "data").string();
  const auto deck = test::replaced(first_deck(read_text(documentation / "decks.md")), "../data", data);
  const auto study = directory.study(deck);
  EXPECT_EQ(study.title, "PBX-9501 at 19 degC");
  EXPECT_EQ(study.stages.at(0).cells, 200);
}

}  // namespace
}  // namespace breccia
