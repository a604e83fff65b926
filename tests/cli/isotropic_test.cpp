// Decks that ask for the isotropic mean of all shears, through the command line.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "model_deck.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

/// Expects that the isotropic curve of stage A is the mean of the curves under these loads.
void expect_mean(const std::filesystem::path& curves, const std::vector<std::string>& loads,
                 const std::string& method) {
  const auto mean = read_curve(curves, "A", "isotropic", method);
  ASSERT_FALSE(mean.empty());
  std::vector<double> sum(mean.size(), 0.0);
  for (const auto& load : loads) {
    const auto curve = read_curve(curves, "A", load, method);
    ASSERT_EQ(curve.size(), mean.size()) << load;
    for (std::size_t i = 0; i < curve.size(); ++i) sum[i] += curve[i].modulus / static_cast<double>(loads.size());
  }
  // A curve under one load is written with all its digits.
  for (std::size_t i = 0; i < mean.size(); ++i) EXPECT_NEAR(mean[i].modulus / sum[i], 1.0, 1e-12);
}

/// The model composite under all shears and in bulk.
class IsotropicMeanOfARun : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study = std::make_unique<StudyDirectory>(model_deck);
    run = study->breccia(
        "run", {"--set", R"(tests.loads=["isotropic", "bulk"])", "--set", R"(tests.method=["quasistatic", "dynamic"])",
                "--set", R"(tests.times=["1 ms", "5 ms"])"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
  }
  static void TearDownTestSuite() { study.reset(); }

  static inline std::unique_ptr<StudyDirectory> study;
  static inline Outcome run;
};

TEST_F(IsotropicMeanOfARun, IsThatOfItsShearsByBothMethods) {
  expect_mean(study->result("curves.csv"), {"shear", "shear-xx-yy"}, "quasistatic");
  expect_mean(study->result("curves.csv"), {"shear", "shear-xx-yy"}, "dynamic");
}

TEST_F(IsotropicMeanOfARun, IsShownWithTheDistanceOfTheShears) {
  EXPECT_THAT(run.output, AllOf(HasSubstr("G       K + G/3             G       K + G/3             E\n"),
                                Not(HasSubstr("G, xx-yy")), HasSubstr("; shears "), HasSubstr(" apart at 1 ms, ")));
  const auto file = study->result("curves.csv");
  const auto xy = read_curve(file, "A", "shear", "quasistatic"),
             diagonal = read_curve(file, "A", "shear-xx-yy", "quasistatic");
  const auto json = Json::parse(read_text(study->result("study.json")));
  const auto& stage = json["stages"][0];
  const double ratio = diagonal.front().modulus / xy.front().modulus;
  EXPECT_GE(stage["quality"]["anisotropy"]["first"]["relative_distance"].get<double>(),
            std::max(ratio, 1.0 / ratio) - 1.001);
  const auto mean = std::ranges::find_if(stage["tests"], [](const Json& test) { return test["load"] == "isotropic"; });
  ASSERT_NE(mean, stage["tests"].end());
  EXPECT_THAT((*mean)["mean_of"].get<std::vector<std::string>>(), ElementsAre("shear", "shear-xx-yy"));
}

TEST_F(IsotropicMeanOfARun, IsTheShearModulusOfYoungsModulus) {
  const auto table = read_csv(
      study->result("engineering.csv"),
      {"stage", "boundary", "method", "cells", "bulk_modulus_error", "youngs_modulus_error", "poisson_ratio_error"});
  const auto mean = read_curve(study->result("curves.csv"), "A", "isotropic", "quasistatic");
  ASSERT_GE(table.rows(), mean.size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    EXPECT_NEAR(table.numbers("shear_modulus_Pa")[i] / mean[i].modulus, 1.0, 1e-9);
  }
}

TEST_F(IsotropicMeanOfARun, IsExportedUnlessAnotherLoadIsNamed) {
  const auto exported = [](const std::vector<std::string>& load) {
    std::vector<std::string> arguments = {"export", "out", "--format", "csv"};
    arguments.insert(arguments.end(), load.begin(), load.end());
    return run_breccia(study->path(), arguments);
  };
  const auto card = exported({});
  ASSERT_EQ(card.exit_code, 0) << card.errors;
  EXPECT_THAT(card.output, HasSubstr("isotropic"));
  EXPECT_THAT(exported({"--load", "shear"}).output, Not(HasSubstr("isotropic")));
  EXPECT_THAT(exported({"--load", "bulk"}).errors, HasSubstr("expected a load of shear"));
}

// In a lattice with the symmetry of a cube three shears of the axes are alike, and so are two of the diagonals.
TEST(IsotropicMean, OfALatticeInSpaceIsThatOfFiveShears) {
  StudyDirectory study(R"(title = "Lattice"
dimensions = 3
[materials.rubber]
density = "1 g/cm^3"
bulk    = "2 GPa"
shear   = { equilibrium = "0.5 GPa", terms = [{ time = "1 ms", modulus = "1 GPa" }] }
[materials.beads]
density = "2 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"
[[stages]]
name    = "A"
matrix  = "rubber"
box     = "1 mm"
cells   = 8
filler  = { material = "beads", sizes = { diameter = "0.8 mm" } }
packing = { method = "regular", lattice = "sc", repeats = 1 }
[tests]
times      = ["0.1 ms", "10 ms"]
loads      = "isotropic"
boundaries = ["periodic"]
)");
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto file = study.result("curves.csv");
  expect_mean(file, {"shear", "shear-xx-yy", "shear-yz", "shear-zx", "shear-zz"}, "quasistatic");
  const auto axes = read_curve(file, "A", "shear"), diagonal = read_curve(file, "A", "shear-xx-yy");
  const auto axial = read_curve(file, "A", "shear-zz"), mean = read_curve(file, "A", "isotropic");
  for (std::size_t i = 0; i < mean.size(); ++i) {
    EXPECT_NEAR(axial[i].modulus / diagonal[i].modulus, 1.0, 1e-5);
    EXPECT_NEAR(mean[i].modulus / (0.6 * axes[i].modulus + 0.4 * diagonal[i].modulus), 1.0, 1e-5);
  }
}

}  // namespace
}  // namespace breccia::test
