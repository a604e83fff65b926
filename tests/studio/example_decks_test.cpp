#include "studio/example_decks.hpp"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "io/text_file.hpp"
#include "temporary_directory.hpp"

namespace breccia::studio {
namespace {

namespace fs = std::filesystem;

const fs::path examples = BRECCIA_EXAMPLES_DIRECTORY;

TEST(ExampleDecks, HaveATitleAndSayWhatTheyAre) {
  const auto decks = example_decks(examples);
  ASSERT_GT(decks.size(), 20U);
  EXPECT_TRUE(decks.front().name.starts_with("materials/"));
  for (const auto& deck : decks) EXPECT_FALSE(deck.title.empty()) << deck.name;
  const auto concrete = std::ranges::find(decks, "materials/concrete/concrete.toml", &ExampleDeck::name);
  ASSERT_NE(concrete, decks.end());
  EXPECT_FALSE(concrete->about.empty());
}

TEST(CopyExample, BringsTheFilesThatADeckNames) {
  const test::TemporaryDirectory directory;
  Folder folder(directory.path());
  const auto deck = copy_example(examples, "pbx9501-hb1.toml", folder, "mine.toml");
  EXPECT_EQ(deck.name, "mine.toml");
  EXPECT_EQ(deck.text.find("../data"), std::string::npos);
  EXPECT_EQ(read_text(directory.path() / "hmx_sizes.csv"),
            read_text(examples.parent_path() / "data" / "hmx_sizes.csv"));
  EXPECT_TRUE(fs::exists(directory.path() / "pbx9501_binder_prony.csv"));
}

TEST(CopyExample, RefusesWhatIsNoExample) {
  const test::TemporaryDirectory directory;
  Folder folder(directory.path());
  EXPECT_THROW(copy_example(examples, "../README.md", folder, "a.toml"), InputError);
  EXPECT_THROW(copy_example(examples, "no.toml", folder, "a.toml"), InputError);
  EXPECT_THROW(copy_example(examples, "pbx9501-hb1.toml", folder, "../a.toml"), InputError);
  (void)folder.add_deck("taken.toml", "");
  EXPECT_THROW(copy_example(examples, "pbx9501-hb1.toml", folder, "taken.toml"), Conflict);
  EXPECT_TRUE(folder.files({".csv"}).empty());
  write_text(directory.path() / "hmx_sizes.csv", "another table");
  EXPECT_THROW(copy_example(examples, "pbx9501-hb1.toml", folder, "a.toml"), Conflict);
  EXPECT_FALSE(fs::exists(directory.path() / "a.toml"));
}

}  // namespace
}  // namespace breccia::studio
