#include "deck/deck_names.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/deck/read_study.hpp"
#include "breccia/error.hpp"

#include "deckfile/deck_tree.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string deck = R"(# A chain.
[materials.binder]  # soft
bulk = "3 GPa"

[materials.glass]
bulk = "30 GPa"

[[stages]]
name    = "fine"
matrix  = "binder"
filler  = [{ material = "glass", coating = { material = "binder" } }, { material = { any = ["glass", "void"] } }]
packing = { method = "random" }

[[stages]]
name   = "coarse"
matrix = "fine"
[stages.packing]
method = "image"
labels = [{ value = 0, material = "fine" }, { value = 1, material = "glass" }]

[[stages]]
name   = "last"
matrix = "coarse"
[stages.packing]
method = "image"
labels = { dark = "coarse", bright = "glass" }

[tests.quasistatic]
vary = { glass = { shear = ["1 GPa", "2 GPa"] } }

[[measurements]]
name  = "glass"
stage = "fine"

[sweep]
"materials.glass.bulk" = ["30 GPa", "40 GPa"]
"stages.fine.filler.0.material" = ["glass", "void"]
"stages.*.matrix" = ["binder", "fine"]
"tests.quasistatic.vary.glass.shear" = [1]
)";

std::string named(const DeckPath& path, const std::string& name) {
  return deck_with_name(deck, path, name);
}

/// The lines of the deck that another text has otherwise, with the other ones behind them.
std::vector<std::string> changed_lines(const std::string& text) {
  const auto lines_of = [](const std::string& whole) {
    std::vector<std::string> lines(1);
    for (const char letter : whole) {
      if (letter == '\n')
        lines.emplace_back();
      else
        lines.back() += letter;
    }
    return lines;
  };
  const auto before = lines_of(deck);
  const auto after = lines_of(text);
  std::vector<std::string> changed;
  EXPECT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] != after[i]) changed.push_back(after[i]);
  }
  return changed;
}

TEST(DeckWithName, AMaterialIsRenamedWhereverTheDeckNamesIt) {
  const std::vector<std::string> expected = {
      "[materials.stone]",
      "filler  = [{ material = \"stone\", coating = { material = \"binder\" } }, { material = { any = [\"stone\", "
      "\"void\"] } }]",
      "labels = [{ value = 0, material = \"fine\" }, { value = 1, material = \"stone\" }]",
      "labels = { dark = \"coarse\", bright = \"stone\" }",
      "vary = { stone = { shear = [\"1 GPa\", \"2 GPa\"] } }",
      "\"materials.stone.bulk\" = [\"30 GPa\", \"40 GPa\"]",
      "\"stages.fine.filler.0.material\" = [\"stone\", \"void\"]",
      "\"tests.quasistatic.vary.stone.shear\" = [1]"};
  EXPECT_EQ(changed_lines(named({"materials", "glass"}, "stone")), expected);
  const std::vector<std::string> of_binder = {
      "[materials.\"type 2.1\"]  # soft", "matrix  = \"type 2.1\"",
      "filler  = [{ material = \"glass\", coating = { material = \"type 2.1\" } }, { material = { any = [\"glass\", "
      "\"void\"] } }]",
      "\"stages.*.matrix\" = [\"type 2.1\", \"fine\"]"};
  EXPECT_EQ(changed_lines(named({"materials", "binder"}, "type 2.1")), of_binder);
}

TEST(DeckWithName, AStageIsRenamedWhereverTheDeckNamesIt) {
  const std::vector<std::string> expected = {
      "name    = \"mastic\"",
      "matrix = \"mastic\"",
      "labels = [{ value = 0, material = \"mastic\" }, { value = 1, material = \"glass\" }]",
      "stage = \"mastic\"",
      "\"stages.mastic.filler.0.material\" = [\"glass\", \"void\"]",
      "\"stages.*.matrix\" = [\"binder\", \"mastic\"]"};
  EXPECT_EQ(changed_lines(named({"stages", 0U}, "mastic")), expected);
}

TEST(DeckWithName, AMatrixOfTheNameOfAMaterialIsTheMaterial) {
  const std::string text =
      "[materials.a]\n[[stages]]\nname = \"a\"\nmatrix = \"a\"\n[[stages]]\nname = \"b\"\nmatrix = \"a\"\n";
  EXPECT_EQ(deck_with_name(text, DeckPath{"stages", 0U}, "c"), test::replaced(text, "name = \"a\"", "name = \"c\""));
  EXPECT_EQ(deck_with_name("[[stages]]\nx = 1\n", DeckPath{"stages", 0U}, "c"), "[[stages]]\nx = 1\nname = \"c\"\n");
}

TEST(DeckWithName, NamesThatAreTakenAreRefused) {
  const auto refusal = [](const DeckPath& path, const std::string& name) {
    return test::message_of<InputError>([&] { (void)named(path, name); });
  };
  EXPECT_THAT(refusal({"materials", "glass"}, "binder"), HasSubstr("there is a material binder already"));
  EXPECT_THAT(refusal({"materials", "glass"}, "fine"), HasSubstr("there is a stage fine already"));
  EXPECT_THAT(refusal({"materials", "glass"}, "void"), HasSubstr("void"));
  EXPECT_THAT(refusal({"materials", "glass"}, ""), HasSubstr("a name is missing"));
  EXPECT_THAT(refusal({"tests", "quasistatic"}, "a"), HasSubstr("no material and no stage"));
  EXPECT_EQ(named({"materials", "glass"}, "glass"), deck);
}

TEST(DeckWithName, SweepsInTablesAreRenamedToo) {
  const std::string text = R"([materials.glass]
bulk = "30 GPa"
[[stages]]
name = "fine"
[sweep]
materials.glass.bulk = ["30 GPa", "40 GPa"]
stages.b.packing.labels.0.material = ["fine", "glass"]
)";
  EXPECT_THAT(deck_with_name(text, DeckPath{"materials", "glass"}, "quartz"),
              AllOf(HasSubstr("materials.quartz.bulk = ["), HasSubstr(R"(labels.0.material = ["fine", "quartz"])")));
  EXPECT_THAT(deck_with_name(text, DeckPath{"stages", 0U}, "mortar"),
              HasSubstr(R"(labels.0.material = ["mortar", "glass"])"));
}

TEST(DeckWithName, APathIntoAnArrayIsNoMaterial) {
  const std::string text = "[[materials]]\nbulk = \"1 GPa\"\n";
  EXPECT_THAT(test::message_of<InputError>([&] {
                (void)deck_with_name(text, DeckPath{"materials", 0U}, "a");
              }),
              HasSubstr("no material"));
}

/// The decks of examples/ can be read with other names of all materials and stages: none names one that is not there.
TEST(DeckWithName, ExamplesAreReadUnderOtherNames) {
  for (const auto& file : std::filesystem::directory_iterator(BRECCIA_EXAMPLES_DIRECTORY)) {
    if (file.path().extension() != ".toml") continue;
    SCOPED_TRACE(file.path().string());
    auto text = read_text(file.path());
    const auto root = detail::parse_deck("deck", text);
    const auto* materials = find(root, "materials");
    const auto* stages = find(root, "stages");
    if (materials == nullptr || stages == nullptr) continue;
    std::size_t count = 0;
    for (const auto& entry : std::get<detail::DeckTable>(materials->content).entries) {
      text = deck_with_name(text, DeckPath{"materials", entry.key}, "material-" + std::to_string(++count));
    }
    for (std::size_t i = 0; i < std::get<detail::DeckArray>(stages->content).values.size(); ++i) {
      text = deck_with_name(text, DeckPath{"stages", i}, "stage-" + std::to_string(++count));
    }
    EXPECT_NO_THROW((void)study_from_text(text, file.path().parent_path()));
  }
}

TEST(DeckWithOrder, StagesChangePlaces) {
  const std::string text = "[[stages]]\nname = \"a\"\n\n[[stages]]\nname = \"b\"\n";
  EXPECT_EQ(deck_with_order(text, DeckPath{"stages", 0U}, DeckPath{"stages", 1U}),
            "[[stages]]\nname = \"b\"\n\n[[stages]]\nname = \"a\"\n");
  const auto refusal = [](const std::string& whole, const DeckPath& one, const DeckPath& other) {
    return test::message_of<InputError>([&] { (void)deck_with_order(whole, one, other); });
  };
  EXPECT_THAT(refusal(text + "[sweep]\n\"stages.0.cells\" = [1, 2]\n", {"stages", 0U}, {"stages", 1U}),
              HasSubstr("counts the stages"));
  EXPECT_THAT(refusal(text + "[sweep]\nstages.0.cells = [1, 2]\n", {"stages", 0U}, {"stages", 1U}),
              HasSubstr("counts the stages"));
  EXPECT_THAT(refusal(text + "[[measurements]]\nname = \"m\"\n", {"stages", 0U}, {"stages", 1U}),
              HasSubstr("a measurement without a stage is one of the last stage"));
  EXPECT_THAT(refusal("a = 1\nb = 2\n", {"a"}, {"b"}), HasSubstr("no material and no stage"));
}

}  // namespace
}  // namespace breccia
