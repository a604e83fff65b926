#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"
#include "good_deck.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

/// A line of the good deck, a mistyped line in its place, and the message that `breccia check` must print about it.
struct BadDeck {
  const char* good;
  const char* bad;
  const char* message;
};

const std::vector<BadDeck> bad_decks{
    {"bulk    = \"3.6 GPa\"", "bulk    = \"3.6 um\"",
     "deck.toml:5:11: materials.binder.bulk: expected a pressure, got \"3.6 um\""},
    {"bulk    = \"3.6 GPa\"", "bulk    = 3.6", "expected a pressure with its unit, such as \"3.6 GPa\", got 3.6"},
    {"bulk    = \"3.6 GPa\"", "bulk    = 3.6 GPa", "deck.toml:5:15: not TOML"},
    {"bulk    = \"3.6 GPa\"", "bulk    = \"-3.6 GPa\"", "expected a positive pressure, got \"-3.6 GPa\""},
    {"bulk    = \"3.6 GPa\"", "bulk    = \"3.6 GPA\"", R"(unknown unit "GPA", did you mean "GPa"?)"},
    {"density = \"1.48 g/cm^3\"", "", "deck.toml:3:1: materials.binder.density: missing, expected a density such as"},
    {"density = \"1.48 g/cm^3\"", "denisty = \"1 g/cm^3\"", R"(unknown key "denisty", did you mean "density"?)"},
    {"time = \"10 ms\"", "time = \"0 ms\"", "shear.terms.0.time: expected a positive time, got \"0 ms\""},
    {R"({ terms = [ { time = "10 ms", modulus = "1 MPa" } ] })", "{ prony = \"none.csv\" }",
     "materials.binder.shear.prony: no such file: none.csv"},
    {"[materials.hmx]", "[material.hmx]", R"(unknown key "material", did you mean "materials"?)"},
    {"matrix  = \"binder\"", "matrix  = \"bindre\"",
     R"(stages.A.matrix: unknown material or earlier stage "bindre", did you mean "binder"?)"},
    {"material = \"hmx\"", "material = \"rdx\"", "stages.A.filler.material: unknown material \"rdx\""},
    {"name    = \"A\"", "name    = \"../A\"", "it names a directory"},
    {"name    = \"A\"", "", "stages.0.name: missing"},
    {"[[stages]]", "[stages]", "deck.toml:13:1: stages: expected an array of tables, got a table"},
    {"box     = \"6 mm\"", "box     = \"6 ms\"", "stages.A.box: expected a length, got \"6 ms\""},
    {"cells   = 60", "cells   = 60.5", "stages.A.cells: expected an integer from 2 to 1048576, got 60.5"},
    {"cells   = 60", "resolution = \"66\"",
     R"(expected a reciprocal length with its unit, such as "12500 /mm", got "66")"},
    {"filler  =", "filer   =", R"(stages.A: unknown key "filer", did you mean "filler"?)"},
    {"fraction = 0.5", "fraction = 50",
     "stages.A.filler.fraction: expected a number between 0 and 1, or per cent as in \"35 %\", got 50"},
    {"sizes = { diameter = \"1 mm\" }", "sizes = \"hmx.csv\"", "stages.A.filler.sizes: no such file: hmx.csv"},
    {"diameter = \"1 mm\"", "diameter = \"7 mm\"", "a particle of 7 mm does not fit into a box of 6 mm"},
    {"gap = \"0.1 mm\"", "gap = \"6 pints\"", R"(or a number of material points such as "6 points", got "6 pints")"},
    {"seed = 1", "seed = \"one\"", "stages.A.packing.seed: expected a non-negative integer, got \"one\""},
    {"lubachevsky-stillinger", "lubachevski-stillinger", "did you mean \"lubachevsky-stillinger\"?"},
    {"[[stages]]", "[stages]", "got a table: write [[stages]] in the place of [stages]"},
    {"cells   = 60", "cells   = 150.0", "expected an integer from 2 to 1048576, got 150.0"},
    {"bulk    = \"3.6 GPa\"", "bulk    = \"3,6 GPa\"", "expected a decimal point, got a comma"},
    {"bulk    = \"3.6 GPa\"", "bulk    = “3.6 GPa”", "deck.toml:5:11: not TOML: the character “ is no quote of TOML"},
    {"[tests]", "[test]", R"(unknown key "test", did you mean "tests"?)"},
    {R"("10 us", "100 ms")", "\"10 us\"", "tests.times: expected two rising times"},
    {"[tests]", "[tests]\nboundaries = [\"tracton\"]", R"(got "tracton", did you mean "traction"?)"},
    {"[tests]", "[tests]\nbounds = [\"upper\"]", "it is called boundaries now"},
    {"[tests]", "[tests]\nsolver = \"steps\"", R"(tests.solver: expected one of "reduced", "stepping", got "steps")"},
    {"cells   = 60", "cells   = [60, 30]", "stages.A.cells: expected an integer, or two or three rising ones"},
};

TEST(BadDecks, AreRefusedWithHelp) {
  const test::TemporaryDirectory directory;
  for (const auto& [good, bad, message] : bad_decks) {
    const auto text = test::replaced(std::string(test::good_deck), good, bad);
    ASSERT_NE(text, test::good_deck) << good << " is not in the good deck";
    directory.write("deck.toml", text);
    const auto outcome = test::run_breccia(directory.path(), {"check", "deck.toml"});
    EXPECT_EQ(outcome.exit_code, 2) << bad;
    EXPECT_EQ(outcome.output, "") << bad;
    EXPECT_THAT(outcome.errors, testing::HasSubstr(message)) << bad;
  }
}

TEST(BadDecks, AllMistakesComeAtOnce) {
  const test::TemporaryDirectory directory;
  auto text = std::string(test::good_deck);
  text = test::replaced(text, "3.6 GPa", "3.6 um");
  text = test::replaced(text, "cells   = 60", "cells   = 1");
  text = test::replaced(text, "100 ms", "100 m");
  directory.write("deck.toml", text);
  const auto outcome = test::run_breccia(directory.path(), {"check", "deck.toml"});
  EXPECT_EQ(outcome.errors,
            "deck.toml:5:11: materials.binder.bulk: expected a pressure, got \"3.6 um\"\n"
            "deck.toml:17:11: stages.A.cells: expected an integer from 2 to 1048576, got 1\n"
            "deck.toml:23:20: tests.times: expected a time, got \"100 m\"\n");
}

}  // namespace
}  // namespace breccia
