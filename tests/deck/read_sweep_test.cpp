#include "breccia/deck/read_sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "study/identity.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SweepDeck : public testing::Test {
 protected:
  [[nodiscard]] Sweep read(const std::string& sweep, const std::vector<std::string>& further = {}) const {
    return read_sweep(directory.written("deck.toml", deck + sweep), {}, further);
  }
  [[nodiscard]] std::vector<std::string> names(const std::string& sweep,
                                               const std::vector<std::string>& further = {}) const {
    std::vector<std::string> all;
    for (const auto& task : read(sweep, further).tasks) all.push_back(task.name);
    return all;
  }
  [[nodiscard]] std::string mistakes(const std::string& sweep, const std::vector<std::string>& further = {}) const {
    const auto message = test::message_of<InputError>([&] { static_cast<void>(read(sweep, further)); });
    return test::replaced(message, directory.path().string() + "/", "");
  }

  test::DeckDirectory directory;
  /// The sweep begins in line 21.
  std::string deck = test::join(test::materials, test::stage, test::tests);
};

std::uint64_t seed_of(const SweepTask& task) {
  return task.study.stages.at(0).packed_by<LubachevskyStillingerPacking<2>>()->seed;
}

TEST_F(SweepDeck, IsOneTaskWithoutASweep) {
  const auto sweep = read("");
  EXPECT_TRUE(sweep.keys.empty());
  ASSERT_EQ(sweep.tasks.size(), 1U);
  EXPECT_EQ(sweep.tasks[0].name, "");
  EXPECT_EQ(sweep.tasks[0].study.provenance.hash, directory.study(deck).provenance.hash);
}

TEST_F(SweepDeck, HasAllCombinations) {
  const auto sweep = read(
      "[sweep]\n\"tests.volumetric\" = [\"averaged\", \"standard\"]\n"
      "\"stages.*.packing.seed\" = { from = 3, to = 4 }\n");
  ASSERT_EQ(sweep.tasks.size(), 4U);
  EXPECT_EQ(sweep.tasks[1].name, "volumetric-averaged_seed-4");
  EXPECT_EQ(sweep.tasks[2].name, "volumetric-standard_seed-3");
  EXPECT_EQ(seed_of(sweep.tasks[1]), 4U);
  EXPECT_EQ(sweep.tasks[2].study.tests.volumetric, Volumetric::standard);
  EXPECT_FALSE(sweep.keys[0].is_seed);
  EXPECT_TRUE(sweep.keys[1].is_seed);
  EXPECT_THAT(sweep.tasks[2].labels, ElementsAre("volumetric-standard", "seed-3"));
}

TEST_F(SweepDeck, ATaskIsTheDeckWithOverrides) {
  const auto task = read("[sweep]\n\"tests.volumetric\" = [\"standard\"]\n").tasks.at(0);
  EXPECT_THAT(task.study.provenance.overrides, ElementsAre("tests.volumetric=\"standard\""));
  EXPECT_EQ(task.study.provenance.content, content_of(task.study));
  EXPECT_EQ(directory.study(deck + "# ", task.study.provenance.overrides).tests.volumetric, Volumetric::standard);
}

TEST_F(SweepDeck, TakesNamesWithDotsInTables) {
  deck = test::replaced(deck, "\"HB-1\"", "\"HB.1\"");
  EXPECT_THAT(names("[sweep.stages.\"HB.1\"]\ncells = [10, 20]\n"), ElementsAre("cells-10", "cells-20"));
  EXPECT_THAT(names("[sweep]\nstages.\"HB.1\".filler.from = [\"2 um\", \"3 um\"]\n"),
              ElementsAre("from-2-um", "from-3-um"));
  EXPECT_THAT(names("[sweep]\n'stages.\"HB.1\".cells' = [10, 20]\n"), ElementsAre("cells-10", "cells-20"));
}

TEST_F(SweepDeck, NamesNoTaskTooLongForADirectory) {
  std::string sweep = "[sweep]\n";
  for (const auto* key : {"title", "b", "c", "d", "e"})
    sweep += std::string(key) + " = [\"" + std::string(40, 'x') + "\"]\n";
  EXPECT_THAT(mistakes(sweep), HasSubstr("deck.toml:22:1: the name of a task, title-xxx"));
  EXPECT_THAT(mistakes(sweep), HasSubstr("has 218 letters; at most 200 are possible"));
}

TEST_F(SweepDeck, KeepsTheOverridesOfAllTasksApart) {
  const auto file = directory.written("deck.toml", deck + "[sweep]\n\"tests.volumetric\" = [\"standard\"]\n");
  const auto sweep = read_sweep(file, {"tests.points_per_decade=5"}, {});
  EXPECT_THAT(sweep.overrides, ElementsAre("tests.points_per_decade=5"));
  EXPECT_THAT(sweep.tasks.at(0).study.provenance.overrides,
              ElementsAre("tests.points_per_decade=5", "tests.volumetric=\"standard\""));
}

TEST_F(SweepDeck, TakesKeysInTablesAndFromTheCommandLine) {
  EXPECT_THAT(names("[sweep]\nstages.HB-1.filler.from = [\"2 um\", \"3 um\"]\n"),
              ElementsAre("from-2-um", "from-3-um"));
  EXPECT_THAT(names("", {"stages.*.packing.seed=[1, 2]"}), ElementsAre("seed-1", "seed-2"));
  EXPECT_THAT(names("[sweep]\n\"stages.0.packing.seed\" = [1, 2]\n", {"tests.points_per_decade={ from = 5, to = 6 }"}),
              ElementsAre("seed-1_points_per_decade-5", "seed-1_points_per_decade-6", "seed-2_points_per_decade-5",
                          "seed-2_points_per_decade-6"));
}

const std::string regular_stage = R"([[stages]]
name    = "regular"
matrix  = "binder"
box     = "6 mm"
cells   = 12
filler  = { material = "hmx", sizes = { diameter = "2 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }
)";

TEST_F(SweepDeck, TheSeedOfAllPackingsIsSetInRandomOnesOnly) {
  const std::string every_seed = "stages.*.packing.seed=[7, 8]";
  deck = test::join(test::materials, test::stage, regular_stage, test::tests);
  const auto sweep = read("", {every_seed});
  ASSERT_EQ(sweep.tasks.size(), 2U);
  EXPECT_EQ(sweep.tasks[1].name, "seed-8");
  EXPECT_EQ(seed_of(sweep.tasks[1]), 8U);
  EXPECT_THAT(sweep.tasks[1].study.provenance.overrides, ElementsAre("stages.0.packing.seed=8"));
  EXPECT_THAT(mistakes("", {every_seed, "stages.0.packing.seed=[1]"}), HasSubstr("packing.seed is swept twice"));
  deck = test::join(test::materials, regular_stage, test::tests);
  EXPECT_EQ(mistakes("", {every_seed}),
            "--sweep stages.*.packing.seed=[7, 8]: no stage has a random packing, which alone takes a seed");
}

TEST_F(SweepDeck, RangesOfNumbers) {
  EXPECT_THAT(names("[sweep]\n\"stages.0.filler.fraction\" = { from = 0.5, to = 0.6, count = 3 }\n"),
              ElementsAre("fraction-0.5", "fraction-0.55", "fraction-0.6"));
  EXPECT_THAT(names("[sweep]\n\"stages.0.cells\" = { from = 100, to = 300, count = 3 }\n"),
              ElementsAre("cells-100", "cells-200", "cells-300"));
  EXPECT_THAT(names("[sweep]\n\"tests.quasistatic.tolerance\" = "
                    "{ from = 1e-6, to = 1e-4, count = 3, spacing = \"logarithmic\" }\n"),
              ElementsAre("tolerance-1e-06", "tolerance-1e-05", "tolerance-0.0001"));
}

TEST_F(SweepDeck, KeysOfASecondFiller) {
  deck = test::join(test::materials, R"([[stages]]
name = "HB-1"
matrix = "binder"
box = "48 um"
cells = 300
packing = { method = "lubachevsky-stillinger" }
[[stages.filler]]
material = "hmx"
fraction = 0.3
sizes = { diameter = "8 um" }
[[stages.filler]]
material = "hmx"
fraction = 0.1
sizes = { diameter = "4 um" }
coating = { material = "binder", thickness = "0.3 um" }
)",
                    test::tests);
  const auto sweep = read(
      "[sweep]\n\"stages.HB-1.filler.1.fraction\" = [0.1, 0.2]\n"
      "\"stages.0.filler.1.coating.thickness\" = [\"0.2 um\", \"0.4 um\"]\n");
  ASSERT_EQ(sweep.tasks.size(), 4U);
  const auto& fillers = sweep.tasks[3].study.stages.at(0).fillers;
  EXPECT_EQ(sweep.tasks[3].name, "fraction-0.2_thickness-0.4-um");
  EXPECT_EQ(fillers.at(0).fraction, 0.3);
  EXPECT_EQ(fillers.at(1).fraction, 0.2);
  EXPECT_DOUBLE_EQ(fillers.at(1).coating->thickness, 0.4e-6);
}

TEST_F(SweepDeck, RangesOfQuantities) {
  const auto sweep = read("[sweep]\n\"stages.0.filler.to\" = { from = \"10 um\", to = \"0.02 mm\", count = 3 }\n");
  ASSERT_EQ(sweep.tasks.size(), 3U);
  EXPECT_EQ(sweep.tasks[1].name, "to-15-um");
  EXPECT_EQ(sweep.tasks[1].values.at(0), Scalar(std::string("15 um")));
  EXPECT_EQ(sweep.tasks[2].study.stages.at(0).fillers[0].largest, 20e-6);
  EXPECT_THAT(names("[sweep]\n\"stages.0.filler.gap\" = { from = \"4 points\", to = \"6 points\", count = 2 }\n"),
              ElementsAre("gap-4-points", "gap-6-points"));
  EXPECT_THAT(names("[sweep]\n\"materials.hmx.shear\" = "
                    "{ from = \"10 MPa\", to = \"1 GPa\", count = 3, spacing = \"logarithmic\" }\n"),
              ElementsAre("shear-10-MPa", "shear-100-MPa", "shear-1000-MPa"));
}

TEST_F(SweepDeck, RangesOfTemperatures) {
  deck = test::replaced(deck, "shear = \"1 MPa\"",
                        "shear = { terms = [{ time = \"1 s\", modulus = \"1 MPa\" }] }\ntemperature_shift = { law = "
                        "\"wlf\", c1 = 6.5, c2 = \"120 K\", reference = \"19 degC\", temperature = \"19 degC\" }");
  EXPECT_THAT(names("[sweep]\n\"materials.binder.temperature_shift.temperature\" = "
                    "{ from = \"-40 degC\", to = \"60 degC\", count = 3 }\n"),
              ElementsAre("temperature-minus-40-degC", "temperature-10-degC", "temperature-60-degC"));
}

TEST_F(SweepDeck, RangesReachAsFarAsNumbersDo) {
  constexpr auto seeds = "[sweep]\n\"stages.0.packing.seed\" = ";
  EXPECT_THAT(names(test::join(seeds, "{ from = 9223372036854775806, to = 9223372036854775807 }\n")),
              ElementsAre("seed-9223372036854775806", "seed-9223372036854775807"));
  EXPECT_THAT(names(test::join(seeds, "{ from = 1, to = 9223372036854775807, count = 3 }\n")),
              ElementsAre("seed-1", "seed-4611686018427387904", "seed-9223372036854775807"));
  const auto fractions = [&](const char* range) {
    return mistakes(test::join("[sweep]\n\"stages.0.filler.fraction\" = ", range, "\n"));
  };
  EXPECT_THAT(fractions("{ from = -1e308, to = 1e308, count = 3 }"),
              HasSubstr("expected a number between 0 and 1, or per cent as in \"35 %\", got -1e+308"));
  EXPECT_THAT(fractions("{ from = 1e-320, to = 1e300, count = 2, spacing = \"logarithmic\" }"),
              HasSubstr("expected a number between 0 and 1, or per cent as in \"35 %\", got 1e+300"));
  EXPECT_THAT(fractions("{ from = -9223372036854775807, to = 9223372036854775807 }"),
              HasSubstr("expected at most 1000 values, got 1.84467e+19"));
}

TEST_F(SweepDeck, NamesTellKeysAndFilesApart) {
  EXPECT_THAT(names("[sweep]\n\"materials.binder.bulk\" = [\"3 GPa\"]\n\"materials.hmx.bulk\" = [\"12 GPa\"]\n"),
              ElementsAre("binder-bulk-3-GPa_hmx-bulk-12-GPa"));
  EXPECT_THAT(names("[sweep]\n\"tests.times.1\" = [\"1 s\"]\n"), ElementsAre("times-1-1-s"));
  for (const auto* name : {"a/sizes.csv", "b/sizes.csv", "a/other.csv"}) {
    std::filesystem::create_directories(directory.path() / std::filesystem::path(name).parent_path());
    directory.write(name, "diameter_m,cumulative_volume_fraction\n1e-6,0\n20e-6,1\n");
  }
  EXPECT_THAT(names("[sweep]\n\"stages.*.filler.sizes\" = [\"a/sizes.csv\", \"a/other.csv\"]\n"),
              ElementsAre("sizes-sizes", "sizes-other"));
  EXPECT_THAT(names("[sweep]\n\"stages.*.filler.sizes\" = [\"a/sizes.csv\", \"b/sizes.csv\"]\n"),
              ElementsAre("sizes-a-sizes.csv", "sizes-b-sizes.csv"));
}

TEST_F(SweepDeck, TheHashOfATaskDoesNotDependOnTheOthers) {
  const auto few = read("[sweep]\n\"stages.*.packing.seed\" = [1, 2]\n").tasks;
  const auto many = read("[sweep]\n\"stages.*.packing.seed\" = [2, 3, 4]\n").tasks;
  EXPECT_EQ(few[1].study.provenance.hash, many[0].study.provenance.hash);
  EXPECT_NE(few[0].study.provenance.hash, few[1].study.provenance.hash);
}

/// A sweep with a mistake, and its message.
struct BadSweep {
  const char* sweep;
  const char* message;
};

const std::vector<BadSweep> bad_sweeps{
    {"", "deck.toml:21:1: sweep: expected keys with values, such as \"tests.points_per_decade\" = [10, 20]"},
    {"\"tests.volumetric\" = []", "deck.toml:22:22: sweep.tests.volumetric: expected at least one, got an empty array"},
    {"\"tests.volumetric\" = 3",
     "deck.toml:22:22: sweep.tests.volumetric: expected an array such as [1, 2], or a range such as { from = 1, to = 5 "
     "}"},
    {R"("tests.volumetrc" = ["averaged"])",
     R"(deck.toml:22:1: tests: unknown key "volumetrc", did you mean "volumetric"?)"},
    {R"("tests.volumetric" = ["averaged", "norm"])",
     R"(deck.toml:22:35: tests.volumetric: expected one of "averaged", "standard", got "norm")"},
    {R"("tests.volumetric" = ["averaged", [1]])",
     "deck.toml:22:35: sweep.tests.volumetric: expected a number, text, true or false, got an array"},
    {"\"stages.HB.cells\" = [10]", R"(deck.toml:22:1: stages has no entry "HB"; known: "HB-1")"},
    {"\"stages..cells\" = [10]", R"(deck.toml:22:1: expected a key such as "tests.volumetric", got "stages..cells")"},
    {"\"stages.*.cells\" = [10, 20, 10]", "deck.toml:22:20: sweep.stages.*.cells: 10 stands here twice"},
    {"\"stages.*.cells\" = [10]\n\"stages.0.cells\" = [20]", "deck.toml:23:1: stages.HB-1.cells is swept twice"},
    {"\"sweep.a\" = [1]", "deck.toml:22:1: a sweep cannot sweep itself"},
    {"\"stages.0.cells\" = { from = 5, to = 3 }",
     "deck.toml:22:37: sweep.stages.0.cells.to: expected more than 5, got 3"},
    {"\"stages.0.cells\" = { from = 5 }",
     "deck.toml:22:20: sweep.stages.0.cells: expected count, the number of values"},
    {"\"stages.0.filler.fraction\" = { from = 0.5, to = 0.6 }", "fraction: expected count, the number of values"},
    {"\"stages.0.filler.fraction\" = { from = 0.5, count = 3 }", "fraction.to: missing, expected a number"},
    {"\"stages.0.filler.fraction\" = { from = 0.5, to = 0.6, count = 1 }", "count: expected an integer from 2 to 1000"},
    {R"("stages.0.filler.fraction" = { from = 0.0, to = 0.6, count = 3, spacing = "logarithmic" })",
     "fraction.from: expected a positive number, got 0"},
    {"\"stages.0.filler.fraction\" = { from = 0.5, to = 0.6, cuont = 3 }",
     R"(unknown key "cuont", did you mean "count"?)"},
    {R"("stages.0.filler.gap" = { from = "1 um", to = "2 s", count = 3 })",
     R"(gap.to: expected a quantity in "um", the unit of from, or in another that can be converted to it, got "2 s")"},
    {R"("stages.0.filler.gap" = { from = "2 mm", to = "3 um", count = 3 })",
     R"(gap.to: expected more than "2 mm", got "3 um")"},
    {R"("stages.0.filler.gap" = { from = "1 um", to = 3, count = 3 })",
     "gap.to: expected a number with its unit, as the other end of the range has one"},
    {R"("stages.0.filler.gap" = { from = "um", to = "3 um", count = 3 })",
     R"(gap.from: expected a number with its unit, such as "48 um", got "um")"},
    {R"("stages.0.filler.gap" = { from = "1 um", to = "3 um" })", "gap: expected count, the number of values"},
    {R"("stages.0.filler.gap" = { from = "0 um", to = "3 um", count = 3, spacing = "logarithmic" })",
     R"(gap.from: expected a positive quantity, got "0 um")"},
    {R"("tests.volumetric" = ["a\nb"])", "expected text without line breaks"},
    {R"("stages.0.cells" = { from = 5, to = 8, spacing = "linear" })", "spacing: goes with count"},
    {"\"stages.0.cells\" = { from = 1, to = 5000 }", "to: expected at most 1000 values, got 5000"},
    {"\"stages.0.cells\" = { from = 2, to = 50 }\n\"stages.0.packing.seed\" = { from = 1, to = 50 }",
     "deck.toml:21:1: sweep: expected at most 1000 tasks, got 2450"},
};

TEST_F(SweepDeck, MistakesAreReportedAtTheLineOfTheSweep) {
  for (const auto& [sweep, message] : bad_sweeps) {
    EXPECT_THAT(mistakes(std::string("[sweep]\n") + sweep + "\n"), testing::HasSubstr(message)) << sweep;
  }
}

TEST_F(SweepDeck, AllMistakesOfAllTasksComeOnce) {
  deck = test::replaced(deck, "13.4 GPa", "13.4 um");
  EXPECT_EQ(
      mistakes("[sweep]\n\"stages.*.packing.seed\" = [1, -1, 2.5]\n\"tests.volumetric\" = [\"averaged\", \"norm\"]\n"),
      "deck.toml:8:8: materials.hmx.bulk: expected a pressure, got \"13.4 um\"\n"
      "deck.toml:22:31: stages.HB-1.packing.seed: expected a non-negative integer, got -1\n"
      "deck.toml:22:35: stages.HB-1.packing.seed: expected a non-negative integer, got 2.5\n"
      "deck.toml:23:35: tests.volumetric: expected one of \"averaged\", \"standard\", got \"norm\"");
}

TEST_F(SweepDeck, MistakesOnTheCommandLine) {
  EXPECT_EQ(mistakes("", {"tests.volumetric"}),
            "--sweep tests.volumetric: expected key.path=[value, ...], such as \"stages.*.packing.seed=[1, 2]\"");
  EXPECT_EQ(mistakes("", {"stages.*.cells=[10]", "stages.*.cells=[20]"}),
            "--sweep stages.*.cells=[20]: sweep has \"stages.*.cells\" already");
  EXPECT_EQ(mistakes("", {"stages.*.cells=[1]"}),
            "--sweep stages.*.cells=[1]: stages.HB-1.cells: expected an integer from 2 to 1048576, got 1");
}

}  // namespace
}  // namespace breccia
