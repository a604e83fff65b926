// Tests of grains that are crystals through the command line.

#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

using test::StudyDirectory;
using testing::HasSubstr;

constexpr const char* crystals = R"(
[materials.binder]
density = "1.2 g/cm^3"
bulk    = "3 GPa"
shear   = { equilibrium = "1 MPa", terms = [{ time = "1 ms", modulus = "0.5 GPa" }] }

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

TEST(Crystals, AreListedWithTheirOrientations) {
  const StudyDirectory study(crystals);
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto words = HasSubstr("crystals at random orientations (seed 4); isotropic means by Hill: K 16 GPa");
  EXPECT_THAT(run.output, words);
  const auto record = nlohmann::json::parse(read_text(study.result("study.json")))["stages"][0]["microstructure"];
  EXPECT_THAT(record["crystals"].get<std::string>(), words);
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
  const StudyDirectory study(crystals);
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto curve = test::read_curve(study.result("curves.csv"), "grains", "isotropic");
  ASSERT_EQ(study.breccia("run", {"--set", "stages.0.filler.orientations={seed=9}", "--overwrite"}).exit_code, 0);
  const auto of_other = test::read_curve(study.result("curves.csv"), "grains", "isotropic");
  EXPECT_GT(std::abs(test::modulus_at(of_other, 1e-6) / test::modulus_at(curve, 1e-6) - 1.0), 1e-4);
}

TEST(Crystals, TooFewOrientationsAreRefused) {
  const StudyDirectory study(crystals);
  study.write("angles.csv", "phi1_deg,phi_deg,phi2_deg\n0,0,0\n");
  const auto run = study.breccia("run", {"--set", R"(stages.0.filler.orientations="angles.csv")"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.errors, HasSubstr("expected the orientations of 20 grains, got 1"));
}

TEST(Crystals, InCellsAreRefusedWithTheirMeans) {
  const StudyDirectory study(crystals);
  const auto check = study.breccia("check", {"--set", "tests.model=cells", "--set", "stages.0.cells=64"});
  EXPECT_EQ(check.exit_code, 2);
  EXPECT_THAT(check.errors, HasSubstr("a material with their isotropic means, bulk = \"16 GPa\""));
}

}  // namespace
}  // namespace breccia
