// Tests of crystals through the command line.

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/virtual_test/curve.hpp"

#include "io/text_file.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

using test::StudyDirectory;
using testing::HasSubstr;
using testing::Not;

constexpr const char* binder_around_crystals = R"([materials.binder]
density = "1.2 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "1 MPa", terms = [{ time = "1 ms", modulus = "0.5 GPa" }] }
)";

/// Grains between films.
constexpr const char* crystals_as_grains = R"(
[materials.crystal]
density   = "1.9 g/cm^3"
stiffness = { symmetry = "cubic", C11 = "20 GPa", C12 = "14 GPa", C44 = "12 GPa" }

[[stages]]
name      = "grains"
matrix    = "binder"
particles = 20
filler    = { material = "crystal", fraction = 0.93, sizes = { diameter = "0.1 mm" } }
packing   = { method = "laguerre", seed = 4 }

[tests]
model  = "films"
times  = ["1 us", "0.1 s"]
)";

std::string deck_of_grains() {
  return std::string(binder_around_crystals) + crystals_as_grains;
}

TEST(Crystals, AreListedWithTheirOrientations) {
  const StudyDirectory study(deck_of_grains());
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto words =
      HasSubstr("crystals of crystal at random orientations (seed 4); isotropic means by Hill: K 16 GPa");
  EXPECT_THAT(run.output, words);
  const auto record = nlohmann::json::parse(read_text(study.result("study.json")))["stages"][0]["microstructure"];
  EXPECT_THAT(record["crystals"][0].get<std::string>(), words);
  const auto grains = read_csv(study.result("grains/grains.csv"));
  std::string angles = "phi1_deg,phi_deg,phi2_deg\n";
  for (std::size_t row = 0; row < grains.rows(); ++row) {
    angles += fmt::format("{},{},{}\n", grains.numbers("phi1_deg")[row], grains.numbers("phi_deg")[row],
                          grains.numbers("phi2_deg")[row]);
  }
  study.write("angles.csv", angles);
  const auto curve = test::read_curve(study.result("curves.csv"), "grains", "isotropic");
  const auto again = study.breccia("run", {"--set", R"(stages.0.filler.orientations="angles.csv")", "--overwrite"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  const auto of_list = test::read_curve(study.result("curves.csv"), "grains", "isotropic");
  for (const double time : {1e-6, 1e-3, 1e-1}) {
    EXPECT_NEAR(test::modulus_at(of_list, time) / test::modulus_at(curve, time), 1.0, 1e-6);
  }
}

TEST(Crystals, OfOtherOrientationsHaveOtherModuli) {
  const StudyDirectory study(deck_of_grains());
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto curve = test::read_curve(study.result("curves.csv"), "grains", "isotropic");
  ASSERT_EQ(study.breccia("run", {"--set", "stages.0.filler.orientations={seed=9}", "--overwrite"}).exit_code, 0);
  const auto of_other = test::read_curve(study.result("curves.csv"), "grains", "isotropic");
  EXPECT_GT(std::abs(test::modulus_at(of_other, 1e-6) / test::modulus_at(curve, 1e-6) - 1.0), 1e-4);
}

TEST(Crystals, TooFewOrientationsAreRefused) {
  const StudyDirectory study(deck_of_grains());
  study.write("angles.csv", "phi1_deg,phi_deg,phi2_deg\n0,0,0\n");
  const auto run = study.breccia("run", {"--set", R"(stages.0.filler.orientations="angles.csv")"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, HasSubstr("angles.csv: expected those of 20 grains, got 1"));
}

/// Two fillers of spheres in space, one of them crystals; CRYSTAL is its material's stiffness or moduli.
constexpr const char* crystals_as_spheres = R"(
[materials.crystal]
density   = "1.9 g/cm^3"
CRYSTAL
[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"
[[stages]]
name    = "box"
matrix  = "binder"
box     = "1 mm"
cells   = 12
filler  = [{ material = "glass", sizes = { diameter = "0.3 mm" }, fraction = 0.1 },
           { material = "crystal", sizes = { diameter = "0.4 mm" }, fraction = 0.2 }]
packing = { method = "lubachevsky-stillinger", seed = 2 }
[tests]
times  = ["1 us", "0.1 s"]
loads  = ["isotropic", "bulk"]
mixing = "series"
fields = ["1 us"]
)";

std::string spheres_of(const std::string& crystal) {
  auto deck = std::string("dimensions = 3\n") + binder_around_crystals + crystals_as_spheres;
  return deck.replace(deck.find("CRYSTAL"), 7, crystal);
}

/// The same fillers as discs that almost touch.
std::string as_discs(std::string deck) {
  const std::array<std::pair<std::string, std::string>, 5> changes = {
      {{"dimensions = 3", "dimensions = 2"},
       {"cells   = 12", "cells   = 30"},
       {"fraction = 0.1 }", "fraction = 0.25, gap = \"2 um\" }"},
       {"fraction = 0.2 }", "fraction = 0.35, gap = \"2 um\" }"},
       {"mixing = \"series\"", "mixing = \"flow\""}}};
  for (const auto& [from, to] : changes) deck.replace(deck.find(from), from.size(), to);
  return deck;
}

Curve modulus_of(const StudyDirectory& study, const std::string& load) {
  return test::read_curve(study.result("curves.csv"), "box", load);
}

// Discs have narrow gaps here, through which the binder flows by default.
TEST(Crystals, ThatAreIsotropicAreAFillerInCells) {
  for (const bool in_space : {true, false}) {
    const auto deck = [&](const std::string& moduli) {
      auto text = spheres_of(moduli);
      return in_space ? text : as_discs(std::move(text));
    };
    const StudyDirectory crystals(deck(R"(stiffness = { symmetry = "cubic", C11 = "22 GPa", C12 = "10 GPa", )"
                                       R"(C44 = "6 GPa" })"));
    const StudyDirectory isotropic(deck("bulk = \"14 GPa\"\nshear = \"6 GPa\""));
    for (const auto* study : {&crystals, &isotropic}) {
      const auto run = study->breccia("run");
      ASSERT_EQ(run.exit_code, 0) << run.errors;
    }
    for (const std::string load : {"isotropic", "bulk"}) {
      const auto one = modulus_of(crystals, load), other = modulus_of(isotropic, load);
      for (const double time : {1e-6, 1e-3, 1e-1}) {
        EXPECT_NEAR(test::modulus_at(one, time) / test::modulus_at(other, time), 1.0, 1e-6) << load;
      }
    }
  }
}

TEST(Crystals, AreListedByParticle) {
  const StudyDirectory study(spheres_of(R"(stiffness = { symmetry = "cubic", C11 = "20 GPa", C12 = "14 GPa", )"
                                        R"(C44 = "12 GPa" })"));
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("crystals of crystal at random orientations (seed 2)"));
  const auto list = read_csv(study.result("box/crystals.csv"));
  const auto particles = read_csv(study.result("box/microstructure.csv"));
  ASSERT_GT(list.rows(), 1u);
  for (std::size_t row = 0; row < list.rows(); ++row) {
    EXPECT_EQ(list.numbers("filler")[row], 1.0);
    EXPECT_EQ(particles.numbers("filler")[static_cast<std::size_t>(list.numbers("particle")[row])], 1.0);
  }
  const auto curve = modulus_of(study, "isotropic");
  study.write("angles.csv", read_text(study.result("box/crystals.csv")));
  const auto again = study.breccia("run", {"--set", R"(stages.0.filler.1.orientations="angles.csv")", "--overwrite"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  const auto of_list = modulus_of(study, "isotropic");
  EXPECT_NEAR(test::modulus_at(of_list, 1e-6) / test::modulus_at(curve, 1e-6), 1.0, 1e-9);
  const auto turned = study.breccia("run", {"--set", "stages.0.filler.1.orientations={seed=9}", "--overwrite"});
  ASSERT_EQ(turned.exit_code, 0) << turned.errors;
  const auto of_turned = modulus_of(study, "isotropic");
  EXPECT_GT(std::abs(test::modulus_at(of_turned, 1e-6) / test::modulus_at(curve, 1e-6) - 1.0), 1e-5);
}

// Under a shear of its axes, a cubic crystal acts by one of its constants alone.
TEST(Crystals, AlignedInALatticeActByTheirShears) {
  const auto deck = [](const std::string& filler, const std::string& orientations) {
    return "dimensions = 3\n[materials.binder]\ndensity = \"1 g/cm^3\"\nbulk = \"3 GPa\"\nshear = \"1 GPa\"\n"
           "[materials.filler]\ndensity = \"2 g/cm^3\"\n" +
           filler +
           "\n[[stages]]\nname = \"box\"\nmatrix = \"binder\"\nbox = \"1 mm\"\ncells = 8\n"
           "filler = { material = \"filler\"" +
           orientations +
           " }\npacking = { method = \"explicit\", particles = \"sphere.csv\", walls = false }\n"
           "[tests]\ntimes = [\"1 us\", \"10 us\"]\nloads = [\"shear\", \"shear-xx-yy\"]\nmixing = \"points\"\n";
  };
  const auto moduli = [&](const std::string& filler, const std::string& orientations) {
    const StudyDirectory study(deck(filler, orientations));
    study.write("sphere.csv", "x_um,y_um,z_um,diameter_um\n500,500,500,725.6\n");
    const auto run = study.breccia("run");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    return std::array{test::modulus_at(modulus_of(study, "shear"), 1e-6),
                      test::modulus_at(modulus_of(study, "shear-xx-yy"), 1e-6)};
  };
  const auto crystal = moduli(R"(stiffness = { symmetry = "cubic", C11 = "12.667 GPa", C12 = "8.667 GPa", )"
                              R"(C44 = "8 GPa" })",
                              ", orientations = \"aligned\"");
  const auto as_c44 = moduli("bulk = \"10 GPa\"\nshear = \"8 GPa\"", "");
  const auto as_prime = moduli("bulk = \"10 GPa\"\nshear = \"2 GPa\"", "");
  EXPECT_NEAR(crystal[0] / as_c44[0], 1.0, 3e-3);
  EXPECT_NEAR(crystal[1] / as_prime[1], 1.0, 3e-3);
  EXPECT_GT(as_c44[0] / as_prime[0], 1.1);
}

TEST(Crystals, OfFewCellsAreSaidToBeMostlyIsotropic) {
  const StudyDirectory study(spheres_of(R"(stiffness = { symmetry = "cubic", C11 = "20 GPa", C12 = "14 GPa", )"
                                        R"(C44 = "12 GPa" })"));
  const auto check = study.breccia("check");
  EXPECT_THAT(check.output + check.errors,
              HasSubstr("% of the crystals' volume lies in cells that their surfaces cross"));
  EXPECT_THAT(check.output, HasSubstr("crystals of crystal at random orientations (seed 2)"));
  const auto finer = study.breccia("check", {"--set", "stages.0.cells=40"});
  EXPECT_THAT(finer.output + finer.errors, Not(HasSubstr("of the crystals' volume lies in cells")));
}

TEST(Crystals, DoNotReplaceAMaterialOfAResponse) {
  const StudyDirectory study(spheres_of("bulk = \"14 GPa\"\nshear = \"6 GPa\""));
  ASSERT_EQ(study.breccia("run", {"--set", "stages.0.cells=6"}).exit_code, 0);
  study.write("new.toml",
              "density = \"1 g/cm^3\"\nstiffness = { symmetry = \"cubic\", C11 = \"4 GPa\", C12 = \"3 GPa\", "
              "C44 = \"1 GPa\" }\n");
  const auto respond = test::run_breccia(study.path(), {"respond", "out", "--material", "new.toml"});
  EXPECT_EQ(respond.exit_code, 2);
  EXPECT_THAT(respond.errors, HasSubstr("is a crystal; expected an isotropic material"));
}

TEST(Crystals, WhereTheyCannotBeAreRefusedWithTheirMeans) {
  const StudyDirectory study(deck_of_grains());
  const auto check = study.breccia("check", {"--set", "tests.model=cells", "--set", "stages.0.cells=64", "--set",
                                             "tests.method=dynamic", "--set", "tests.mixing=points"});
  EXPECT_EQ(check.exit_code, 2);
  EXPECT_THAT(
      check.errors,
      HasSubstr("the dynamic method knows isotropic materials alone: expected tests.method = \"quasistatic\", or a "
                "material with their isotropic means, bulk = \"16 GPa\""));
}

}  // namespace
}  // namespace breccia
