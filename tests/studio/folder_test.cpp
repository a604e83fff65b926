#include "studio/folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/text_file.hpp"
#include "temporary_directory.hpp"

namespace breccia::studio {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

class StudioFolder : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((root_ / name).parent_path());
    write_text(root_ / name, text);
  }

  test::TemporaryDirectory temporary_;
  fs::path root_ = temporary_.path() / "work";
};

TEST_F(StudioFolder, ListsDecksWithTheirTitles) {
  write("b.toml", "title = \"Beta\"\n");
  write("a.toml", "title = ");
  write(".hidden.toml", "title = \"no\"\n");
  write("sub/c.toml", "title = \"no\"\n");
  write("data.csv", "a\n1\n");
  const Folder folder(root_);
  const auto decks = folder.decks();
  ASSERT_EQ(decks.size(), 2U);
  EXPECT_EQ(decks[0].name, "a.toml");
  EXPECT_EQ(decks[0].title, "a");
  EXPECT_EQ(decks[1].title, "Beta");
  EXPECT_THAT(folder.files({".csv", ".xlsx"}), ElementsAre("data.csv"));
}

TEST_F(StudioFolder, HasNothingOutsideOfIt) {
  write("a.csv", "inside");
  write(".secret", "hidden");
  write("results/a/.b/c.csv", "hidden");
  write_text(temporary_.path() / "outside.csv", "outside");
  fs::create_symlink(temporary_.path() / "outside.csv", root_ / "link.csv");
  fs::create_directory_symlink(temporary_.path(), root_ / "up");
  fs::create_symlink(root_ / "a.csv", root_ / "own.csv");
  fs::create_directories(temporary_.path() / "work-2");
  write_text(temporary_.path() / "work-2" / "a.csv", "outside");
  const Folder folder(root_);
  EXPECT_EQ(read_text(folder.file("a.csv")), "inside");
  EXPECT_EQ(read_text(folder.file("own.csv")), "inside");
  const auto absolute = (root_ / "a.csv").string();
  for (const auto* name : {"",
                           ".",
                           "..",
                           "../outside.csv",
                           "results/../../outside.csv",
                           "link.csv",
                           "up/outside.csv",
                           ".secret",
                           "results/a/.b/c.csv",
                           "results",
                           "results/",
                           "no.csv",
                           "-x.csv",
                           "--help/study.json",
                           "/etc/passwd",
                           "../work-2/a.csv",
                           "./a.csv",
                           "a.csv/",
                           "a.csv\n",
                           absolute.c_str()}) {
    EXPECT_THROW((void)folder.file(name), InputError) << name;
  }
}

TEST_F(StudioFolder, SavesADeckThatNobodyElseHasChanged) {
  write("a.toml", "x = 1\n");
  Folder folder(root_);
  auto deck = folder.deck("a.toml");
  EXPECT_EQ(deck.text, "x = 1\n");
  deck.text = "x = 2\n";
  deck = folder.save_deck(deck);
  deck.text = "x = 3\n";
  deck = folder.save_deck(deck);
  EXPECT_EQ(read_text(root_ / "a.toml"), "x = 3\n");
  EXPECT_EQ(read_text(root_ / "a.toml~"), "x = 1\n");
  EXPECT_EQ(folder.deck("a.toml").version, deck.version);
}

TEST_F(StudioFolder, RefusesADeckThatSomeoneElseHasChanged) {
  write("a.toml", "x = 1\n");
  Folder folder(root_);
  auto deck = folder.deck("a.toml");
  write("a.toml", "x = 7\n");
  deck.text = "x = 2\n";
  EXPECT_THROW(folder.save_deck(deck), Conflict);
  EXPECT_EQ(read_text(root_ / "a.toml"), "x = 7\n");
  EXPECT_FALSE(fs::exists(root_ / "a.toml~"));
  // The same text is no conflict, whoever wrote it.
  write("a.toml", "x = 2\n");
  EXPECT_EQ(folder.save_deck(deck).text, "x = 2\n");
}

TEST_F(StudioFolder, AddsDecksAndDataWithoutReplacingAny) {
  fs::create_directories(root_);
  Folder folder(root_);
  EXPECT_EQ(folder.add_deck("new.toml", "x = 1\n").text, "x = 1\n");
  EXPECT_THROW(folder.add_deck("new.toml", "x = 2\n"), Conflict);
  for (const auto* name :
       {"", "x", ".toml", "--help.toml", "../a.toml", "a/b.toml", "a\\b.toml", "a\n.toml", "/tmp/a.toml"}) {
    EXPECT_THROW(folder.add_deck(name, ""), InputError) << name;
  }
  folder.add_data("dma.csv", "1");
  folder.add_data("dma.csv", "1");
  EXPECT_THROW(folder.add_data("dma.csv", "2"), Conflict);
  for (const auto* name : {"a.toml", "../dma.csv", ".bashrc", "", "a/b.csv", "-x.csv", "Makefile", "a.toml~", "a.py"}) {
    EXPECT_THROW(folder.add_data(name, "1"), InputError) << name;
  }
  EXPECT_EQ(read_text(root_ / "new.toml"), "x = 1\n");
  EXPECT_EQ(read_text(root_ / "dma.csv"), "1");
}

TEST_F(StudioFolder, KeepsPermissionsAndTheFirstText) {
  write("a.toml", "x = 1\n");
  fs::permissions(root_ / "a.toml", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_directory(root_ / "a.toml~");
  Folder folder(root_);
  auto deck = folder.deck("a.toml");
  deck.text = "x = 2\n";
  EXPECT_THROW(folder.save_deck(deck), FileError);
  EXPECT_EQ(read_text(root_ / "a.toml"), "x = 1\n");
  fs::remove(root_ / "a.toml~");
  (void)folder.save_deck(deck);
  EXPECT_EQ(read_text(root_ / "a.toml~"), "x = 1\n");
  for (const auto* name : {"a.toml", "a.toml~"}) {
    EXPECT_EQ(fs::status(root_ / name).permissions(), fs::perms::owner_read | fs::perms::owner_write) << name;
  }
}

TEST_F(StudioFolder, ShowsNoDeckOutsideAndNoneThatIsNotUtf8) {
  write("a.toml",
        "# 20 \xb0"
        "C\n");
  write_text(temporary_.path() / "outside.toml", "title = \"outside\"\n");
  fs::create_symlink(temporary_.path() / "outside.toml", root_ / "link.toml");
  const Folder folder(root_);
  EXPECT_THROW((void)folder.deck("a.toml"), InputError);
  ASSERT_EQ(folder.decks().size(), 1U);
  EXPECT_EQ(folder.decks()[0].title, "a");
}

TEST_F(StudioFolder, IsADirectory) {
  EXPECT_THROW(Folder(temporary_.path() / "no"), InputError);
}

}  // namespace
}  // namespace breccia::studio
