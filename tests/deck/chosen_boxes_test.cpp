#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/homogenisation/plan.hpp"

#include "decks.hpp"
#include "study/effective_particles.hpp"

namespace breccia {
namespace {

using test::join;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Decks of discs, spheres and grains whose box or grid is left out.
class ChosenBoxes : public testing::Test {
 protected:
  static constexpr std::string_view materials = R"(
[materials.binder]
density = "1 g/cm^3"
bulk = "1 GPa"
shear = { equilibrium = "1 MPa", terms = [{ time = "1 ms", modulus = "10 MPa" }] }
[materials.filler]
density = "2 g/cm^3"
bulk = "10 GPa"
shear = "5 GPa"
)";

  static std::string stage(std::string_view name, std::string_view matrix, std::string_view lines) {
    return join("[[stages]]\nname = \"", name, "\"\nmatrix = \"", matrix, "\"\n", lines,
                "packing = { method = \"lubachevsky-stillinger\" }\n");
  }
  static std::string discs(std::string_view lines) {
    return join(lines,
                "filler = { material = \"filler\", fraction = 0.4, sizes = { diameter = \"1 mm\" }, gap = \"5 %\" }\n");
  }
  static std::string deck(std::string_view stages, std::string_view tests = "", int dimensions = 2) {
    return join("dimensions = ", std::to_string(dimensions), "\n", materials, stages,
                "[tests]\ntimes = [\"0.1 ms\", \"10 ms\"]\n", tests);
  }
  [[nodiscard]] Study study(std::string_view lines, std::string_view tests = "", int dimensions = 2) const {
    return directory.study(deck(stage("a", "binder", discs(lines)), tests, dimensions));
  }
  [[nodiscard]] std::string mistakes(std::string_view lines, std::string_view tests = "") const {
    return directory.mistakes(deck(stage("a", "binder", discs(lines)), tests));
  }
  static std::vector<std::string> warnings(const Study& study) {
    const auto found = study.provenance.warnings.find("a");
    return found == study.provenance.warnings.end() ? std::vector<std::string>() : found->second;
  }
  /// The errors of grid and packing that the plan of a study expects, together [-].
  static double planned_error(const Study& study) {
    const auto plan = plan_of(study).stages.at(0);
    return std::hypot(plan.grid.value().error().value(), plan.sample_error.value());
  }

  test::DeckDirectory directory;
};

TEST_F(ChosenBoxes, ABoxFollowsFromItsParticles) {
  const auto box = study("particles = 100\ncells = 128\n").stages.at(0);
  EXPECT_NEAR(box.side, std::sqrt(100.0 * 0.25 * std::numbers::pi / 0.4) * 1e-3, 1e-7);
  EXPECT_EQ(box.cells, 128);
  EXPECT_EQ(plan_of(study("particles = 100\ncells = 128\n")).stages.at(0).fillers.at(0).particles, 100U);
  EXPECT_EQ(study("particles = 100\nresolution = \"20 /mm\"\n").stages.at(0).cells, 140) << "of 14.0125 mm";
}

TEST_F(ChosenBoxes, BoxAndGridReachTheAccuracyThatIsAskedFor) {
  double seconds = 0.0;
  for (const double percent : {10.0, 5.0, 3.0}) {
    const auto chosen = study("", fmt::format("accuracy = \"{} %\"\n", percent));
    EXPECT_EQ(chosen.tests.accuracy, percent / 100.0);
    EXPECT_LE(planned_error(chosen), 0.0102 * percent);
    EXPECT_GE(planned_error(chosen), 0.007 * percent) << "no more than is needed";
    EXPECT_THAT(warnings(chosen), IsEmpty());
    const double time = plan_of(chosen).seconds();
    EXPECT_GT(time, seconds) << percent;
    seconds = time;
  }
  EXPECT_LT(seconds, 600.0);
}

TEST_F(ChosenBoxes, ThreePercentAreTheDefault) {
  const auto by_default = study(""), asked = study("", "accuracy = 0.03\n");
  EXPECT_EQ(by_default.tests.accuracy, 0.03);
  EXPECT_EQ(by_default.stages.at(0).side, asked.stages.at(0).side);
  EXPECT_EQ(by_default.stages.at(0).cells, asked.stages.at(0).cells);
  EXPECT_EQ(study("box = \"10 mm\"\ncells = 100\n").tests.accuracy, std::nullopt) << "nothing is chosen";
}

TEST_F(ChosenBoxes, TheGridOfAGivenBoxIsChosenForWhatItsParticlesLeave) {
  const auto large = study("particles = 3000\n", "accuracy = \"5 %\"\n");
  EXPECT_THAT(warnings(large), IsEmpty());
  EXPECT_LE(planned_error(large), 0.051);
  const auto small = study("particles = 20\n", "accuracy = \"3 %\"\n");
  EXPECT_THAT(warnings(small), ElementsAre(AllOf(HasSubstr("accuracy 3 %: an error of up to "),
                                                 HasSubstr("a larger box would have a smaller one"))));
  EXPECT_LE(plan_of(small).stages.at(0).grid->error().value(), 0.0213);
}

TEST_F(ChosenBoxes, WhatIsNotReachedWithinTheBudgetIsSaid) {
  const auto chosen = study("", "accuracy = \"3 %\"\nbudget = \"10 s\"\n");
  EXPECT_LE(plan_of(chosen).seconds(), 10.5);
  EXPECT_THAT(warnings(chosen), ElementsAre(AllOf(HasSubstr("accuracy 3 %: within 10 s and 8 GB an error of up to "),
                                                  HasSubstr("3 % would take about "), HasSubstr("(tests.budget)"))));
  const auto longer = study("", "accuracy = \"3 %\"\nbudget = \"30 s\"\n");
  EXPECT_LT(planned_error(longer), planned_error(chosen));
  // More time does not help against a lack of memory.
  EXPECT_THAT(warnings(study("", "accuracy = \"0.5 %\"\n")),
              ElementsAre(AllOf(HasSubstr("0.5 % would take about "), Not(HasSubstr("tests.budget")))));
}

TEST_F(ChosenBoxes, TheStagesOfAChainShareTheAccuracy) {
  const auto two =
      directory.study(deck(stage("fine", "binder", discs("")) + stage("a", "fine", discs("")), "accuracy = \"6 %\"\n"));
  for (const auto& part : plan_of(two).stages) {
    EXPECT_LE(std::hypot(part.grid.value().error().value(), part.sample_error.value()), 0.0102 * 6.0 / std::sqrt(2.0));
  }
}

TEST_F(ChosenBoxes, SpheresHaveThemToo) {
  const auto chosen = study("", "accuracy = \"10 %\"\n", 3);
  EXPECT_THAT(warnings(chosen), IsEmpty());
  EXPECT_LE(planned_error(chosen), 0.102);
  EXPECT_LE(plan_of(chosen).seconds(), 600.0);
}

/// A filler that is softer than the binder at first and stiffer in the end.
TEST_F(ChosenBoxes, WhereNoRuleHoldsTwoGridsMeasureTheError) {
  const auto between = directory.study(deck(stage("a", "binder", discs(""))), {"materials.filler.shear=5 MPa"});
  const auto& box = between.stages.at(0);
  EXPECT_EQ(box.coarser_cells, std::vector{box.cells / 2});
  EXPECT_NEAR(box.cells * 1e-3 / box.side, 20.0, 0.5) << "across a disc";
  EXPECT_EQ(plan_of(between).stages.at(0).fillers.at(0).particles, 64U);
  EXPECT_THAT(warnings(between), ElementsAre(HasSubstr("the error to be expected is not known")));
}

/// Spheres with gaps of 0.5 % would need a grid of 190 cells across each for its error to have a rule.
TEST_F(ChosenBoxes, AGridWithARuleThatIsFarBeyondTheBudgetIsNotChosen) {
  auto text = deck(stage("a", "binder", discs("")), "", 3);
  text.replace(text.find("5 %\""), 3, "0.5 %");
  const auto close = directory.study(text);
  EXPECT_LE(plan_of(close).seconds(), 600.0);
  EXPECT_EQ(close.stages.at(0).coarser_cells.size(), 1U);
  EXPECT_THAT(warnings(close), ElementsAre(HasSubstr("of the grid unknown")));
}

/// Grains may have the thickness of their films in place of a fraction.
TEST_F(ChosenBoxes, GrainsWithFilmsOfAThicknessScatter) {
  const auto grains =
      directory.study(deck("[[stages]]\nname = \"a\"\nmatrix = \"binder\"\n"
                           "filler = { material = \"filler\", sizes = { diameter = \"1 mm\" } }\n"
                           "packing = { method = \"laguerre\", film = \"0.05 mm\" }\n",
                           "accuracy = \"6 %\"\n"));
  EXPECT_GT(plan_of(grains).stages.at(0).sample_error.value(), 0.01);
  EXPECT_LE(planned_error(grains), 0.062);
}

/// Films have an error of their elements, which are shorter where a smaller error is asked for.
TEST_F(ChosenBoxes, FilmsHaveElementsForTheirAccuracy) {
  const auto grains = [this](std::string_view tests) {
    return directory.study(
        deck("[[stages]]\nname = \"a\"\nmatrix = \"binder\"\n"
             "filler = { material = \"filler\", fraction = 0.9, sizes = { diameter = \"1 mm\" } }\n"
             "packing = { method = \"laguerre\" }\n",
             test::join("model = \"films\"\n", tests)));
  };
  const auto fine = grains("accuracy = \"4 %\"\n"), rough = grains("accuracy = \"8 %\"\n");
  EXPECT_EQ(fine.tests.films.face_share, 0.15);
  EXPECT_EQ(rough.tests.films.face_share, 0.3);
  EXPECT_GT(fine.stages.at(0).side, rough.stages.at(0).side);
  EXPECT_THAT(warnings(fine), testing::IsEmpty());
  EXPECT_EQ(grains("accuracy = \"4 %\"\nfilms = { face_share = 0.3 }\n").tests.films.face_share, 0.3);
}

TEST_F(ChosenBoxes, TheSameDeckHasTheSameBox) {
  const auto one = study("", "accuracy = \"4 %\"\n"), other = study("", "accuracy = \"4 %\"\n");
  EXPECT_EQ(one.provenance.hash, other.provenance.hash);
  EXPECT_EQ(one.stages.at(0).side, other.stages.at(0).side);
  EXPECT_NE(one.provenance.hash, study("", "accuracy = \"5 %\"\n").provenance.hash);
}

TEST_F(ChosenBoxes, MistakesAreReported) {
  EXPECT_THAT(mistakes("cells = 100\n"), HasSubstr("box: missing, expected box or particles beside these cells"));
  EXPECT_THAT(mistakes("box = \"10 mm\"\nparticles = 100\ncells = 100\n"), HasSubstr("the box is given already"));
  EXPECT_THAT(mistakes("particles = 0\ncells = 100\n"), HasSubstr("particles: expected an integer from 1 to 100000"));
  EXPECT_THAT(mistakes("particles = 1.5\ncells = 100\n"), HasSubstr("particles: expected an integer"));
  EXPECT_THAT(mistakes("", "accuracy = \"300 %\"\n"), HasSubstr("accuracy: expected"));
  EXPECT_THAT(mistakes("", "budget = \"3 m\"\n"), HasSubstr("budget: expected"));
  EXPECT_THAT(mistakes("box = \"10 mm\"\ncells = 100\n", "budget = \"3 min\"\n"),
              HasSubstr("budget: no box and no cells are left out"));
  EXPECT_THAT(mistakes("", "method = \"dynamic\"\n"), HasSubstr("chosen for the quasi-static method alone"));
  const auto regular = deck(
      "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\n"
      "filler = { material = \"filler\", sizes = { diameter = \"1 mm\" } }\n"
      "packing = { method = \"regular\", columns = 2, rows = 2 }\n");
  EXPECT_THAT(directory.mistakes(regular), HasSubstr("box: missing, expected the side of the box: only particles"));
  const auto empty = deck("[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\n");
  EXPECT_THAT(directory.mistakes(empty), HasSubstr("cells: missing, expected cells or resolution"));
  const auto in_points =
      deck(stage("a", "binder",
                 R"(filler = { material = "filler", fraction = 0.4, gap = "3 points", sizes = { diameter = "1 mm" } }
)"));
  EXPECT_THAT(directory.mistakes(in_points), HasSubstr("gap: a number of material points is a length only where"));
}

TEST_F(ChosenBoxes, MistakesInTheAmountsOfParticlesAreReportedAlone) {
  for (const auto* amount : {"", "fraction = 50, ", "fraction = \"40\", ", "fraction = 0.9999, "}) {
    const auto text = deck(stage("a", "binder",
                                 join("particles = 50\ncells = 50\nfiller = { material = \"filler\", ", amount,
                                      "sizes = { diameter = \"1 mm\" } }\n")));
    if (std::string_view(amount).find("0.9999") == std::string_view::npos) {
      EXPECT_THAT(directory.mistakes(text), AllOf(HasSubstr("fraction"), Not(HasSubstr("stages.a.particles"))));
    } else {
      EXPECT_EQ(directory.study(text).stages.at(0).cells, 50) << "jams later";
    }
  }
  const auto without_sizes = deck(stage("a", "binder", "filler = { material = \"filler\", fraction = 0.4 }\n"));
  EXPECT_THAT(directory.mistakes(without_sizes), AllOf(HasSubstr("sizes"), Not(HasSubstr("box"))));
}

TEST_F(ChosenBoxes, WideSizesAreChosenWithTheirWidth) {
  const auto wide = directory.study(
      deck(stage("a", "binder",
                 "filler = { material = \"filler\", fraction = 0.4, gap = \"0.02 mm\", from = \"0.1 mm\", "
                 "to = \"3 mm\", sizes = { lognormal = [{ median = \"1 mm\", sigma = 0.6 }] } }\n"),
           "accuracy = \"10 %\"\n"));
  EXPECT_TRUE(!warnings(wide).empty() || planned_error(wide) <= 0.115);
}

/// Sizes of which equal ratios have equal areas: the box has an effective number of 16 discs or more, as far as the
/// budget goes.
TEST_F(ChosenBoxes, NoParticleOfADistributionIsMuchOfTheFiller) {
  const auto text =
      deck(stage("a", "binder",
                 "filler = { material = \"filler\", fraction = 0.3, gap = \"0.05 mm\", sizes = { from = \"0.2 mm\", "
                 "to = \"4 mm\" } }\n"),
           "accuracy = \"10 %\"\n");
  const auto side_of = [](const Study& study) { return study.stages.at(0).side; };
  const auto wide = directory.study(text);
  const auto effective = effective_particles_of(wide.stages.at(0)).value();
  EXPECT_GE(std::pow(side_of(wide), 2) / effective.volume, 0.95 * fewest_effective);
  const auto hurried = directory.study(text, {"tests.budget=100 ms"});
  EXPECT_LT(side_of(hurried), side_of(wide));
  EXPECT_THAT(warnings(hurried), Not(IsEmpty()));
}

TEST_F(ChosenBoxes, ParticlesThatJamAreReported) {
  const auto jammed = deck(stage("a", "binder",
                                 "filler = { material = \"filler\", fraction = 0.82, gap = \"8 %\", sizes = { "
                                 "diameter = \"1 mm\" } }\n"));
  EXPECT_THAT(directory.mistakes(jammed), HasSubstr("stages: no box can be chosen: a: 48 particles"));
}

/// With a mistake elsewhere no box is chosen, so that the mistake alone is reported.
TEST_F(ChosenBoxes, AMistakeElsewhereIsReportedAlone) {
  EXPECT_THAT(mistakes("", "loads = \"sheer\"\n"), AllOf(HasSubstr("loads: "), Not(HasSubstr("box"))));
  EXPECT_THAT(mistakes("", "unknown = 1\n"), AllOf(HasSubstr("unknown"), Not(HasSubstr("box:"))));
}

}  // namespace
}  // namespace breccia
