// Tests of studies in three dimensions through the command line.

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/rasters/raster_reader.hpp"

#include "io/hdf5.hpp"
#include "io/text_file.hpp"
#include "lattice_stage.hpp"
#include "study_directory.hpp"

namespace breccia {
namespace {

using test::read_curve;
using test::run_breccia;
using test::StudyDirectory;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// A rubber whose shear modulus relaxes from 100 to 10 MPa.
constexpr std::string_view materials = R"(
dimensions = 3
[materials.rubber]
density = "1.1 g/cm^3"
bulk    = "2 GPa"
shear   = { terms = [ { time = "1 ms", modulus = "90 MPa" } ], equilibrium = "10 MPa" }
[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"
)";

constexpr std::string_view tests = R"(
[tests]
times  = ["10 us", "100 ms"]
loads  = ["shear", "shear-xx-yy", "bulk"]
points_per_decade = 3
)";

const std::string lattice = test::lattice_stage("A", "rubber", "glass");

double shear_of_rubber(double time) {
  return 10e6 + 90e6 * std::exp(-time / 1e-3);
}

TEST(Space, AHomogeneousCubeHasTheModuliOfItsMaterial) {
  StudyDirectory study(fmt::format(
      "{}{}{}boundaries = [\"displacement\", \"traction\", \"periodic\"]\nfit_tolerance = 0.005\n", materials,
      "[[stages]]\nname = \"A\"\nmatrix = \"rubber\"\nbox = \"1 mm\"\ncells = 3\n"
      "[[stages]]\nname = \"B\"\nmatrix = \"A\"\nbox = \"1 mm\"\ncells = 2\n",
      tests));
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  // The matrix of B is a fit to the curves of A, within tests.fit_tolerance.
  for (const auto& [stage, tolerance] : {std::pair<std::string, double>{"A", 1e-6}, {"B", 5e-3}}) {
    for (const std::string load : {"shear", "shear-xx-yy"}) {
      const auto curve = read_curve(study.result("curves.csv"), stage, load);
      ASSERT_FALSE(curve.empty());
      for (const auto& [time, modulus] : curve) EXPECT_NEAR(modulus / shear_of_rubber(time), 1.0, tolerance) << stage;
    }
    // The modulus in bulk is K itself, not K + G/3.
    for (const auto& [time, modulus] : read_curve(study.result("curves.csv"), stage, "bulk")) {
      EXPECT_NEAR(modulus / 2e9, 1.0, tolerance) << stage;
    }
  }
}

TEST(Space, ALatticeOfSpheresLeavesItsFiles) {
  StudyDirectory study(fmt::format("{}{}{}", materials, lattice, tests));
  const auto check = study.breccia("check");
  ASSERT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, AllOf(HasSubstr("8 x 8 x 8 cells"), HasSubstr("4096 material points"),
                                  HasSubstr("cubic lattice \"sc\", 1 repeat, periodic")));
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("26.81 % of the box"));
  EXPECT_THAT(study.results(), AllOf(Contains("A/cut-x.svg"), Contains("A/cut-y.svg"), Contains("A/microstructure.svg"),
                                     Contains("A/labels.vti"), Contains("A/response.h5"), Contains("report.html")));
  EXPECT_THAT(read_text(study.result("A/microstructure.csv")), HasSubstr("x_m,y_m,z_m,diameter_m\n"));
  const auto labels = read_raster(study.result("A/labels.vti"));
  EXPECT_THAT(labels.extents, ElementsAre(16, 16, 16));

  const auto summary = nlohmann::json::parse(read_text(study.result("study.json")));
  const auto& stage = summary["stages"][0];
  EXPECT_EQ(stage["dimensions"], 3);
  EXPECT_EQ(stage["points"], 4096);
  EXPECT_NEAR(stage["microstructure"]["fraction"].get<double>(), 0.268083, 1e-6);
  EXPECT_NEAR(stage["microstructure"]["interface_per_volume_1_per_m"].get<double>(), 3.14159265 * 0.64e-6 / 1e-9, 1e-2);

  // A stiff simple cubic lattice is stiffer against xx - yy, along which spheres are near, than against xy.
  const auto along = read_curve(study.result("curves.csv"), "A", "shear-xx-yy");
  const auto across = read_curve(study.result("curves.csv"), "A", "shear");
  ASSERT_EQ(along.size(), across.size());
  for (std::size_t i = 0; i < along.size(); ++i) {
    EXPECT_GT(along[i].modulus, 1.1 * across[i].modulus);
    EXPECT_GT(across[i].modulus, shear_of_rubber(across[i].time));
  }
}

// In a cube with a sphere, stress waves come to rest at the solution of the method without inertia.
TEST(Space, BothMethodsAgreeOnALatticeOfSpheres) {
  StudyDirectory study(fmt::format("{}{}{}method = [\"quasistatic\", \"dynamic\"]\n", materials, lattice, tests));
  const std::vector<std::string> few = {"--set", R"(tests.loads=["shear-zx", "bulk"])", "--set",
                                        R"(tests.times=["100 us", "10 ms"])"};
  const auto check = study.breccia("check", few);
  ASSERT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, AllOf(HasSubstr("dynamic: 4096 points, about"), HasSubstr("million points x steps/s here"),
                                  HasSubstr("density x")));
  const auto run = study.breccia("run", few);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("time domains"));
  for (const std::string load : {"shear-zx", "bulk"}) {
    const auto still = read_curve(study.result("curves.csv"), "A", load, "quasistatic");
    const auto moving = read_curve(study.result("curves.csv"), "A", load, "dynamic");
    ASSERT_FALSE(still.empty());
    ASSERT_EQ(moving.size(), still.size());
    for (std::size_t i = 0; i < still.size(); ++i) {
      EXPECT_NEAR(moving[i].modulus / still[i].modulus, 1.0, 0.01) << load << " at " << still[i].time;
    }
  }
}

TEST(Space, TheDynamicMethodAloneLeavesFields) {
  StudyDirectory study(fmt::format("{}{}{}method = \"dynamic\"\n", materials, lattice, tests));
  const auto run = study.breccia("run", {"--set", "tests.loads=[\"shear-yz\"]", "--set", "stages.0.cells=6", "--set",
                                         R"(tests.times=["1 ms", "10 ms"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(study.results(),
              AllOf(Contains("A/fields.vtkhdf"), Contains("A/fields-stress.svg"), Contains("A/fields-strain.svg")));
  const auto stress = Hdf5Reader(study.result("A/fields.vtkhdf")).read_numbers("/VTKHDF/CellData/stress_Pa");
  constexpr std::size_t components = 6, yz = 4, cells = 6 * 6 * 6;
  ASSERT_EQ(stress.size(), components * cells);
  double mean = 0.0;
  for (std::size_t cell = 0; cell < cells; ++cell) mean += stress[components * cell + yz] / cells;
  const auto curve = read_curve(study.result("curves.csv"), "A", "shear-yz", "dynamic");
  EXPECT_NEAR(mean / curve.back().modulus, 1.0, 0.02);
}

TEST(Space, RespondAnswersForAnotherMatrix) {
  StudyDirectory study(fmt::format("{}{}{}", materials, lattice, tests));
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  study.write("same.toml", R"(density = "1.1 g/cm^3"
bulk  = "2 GPa"
shear = { terms = [ { time = "1 ms", modulus = "90 MPa" } ], equilibrium = "10 MPa" }
)");
  const auto respond = run_breccia(study.path(), {"respond", "out", "--material", "same.toml"});
  ASSERT_EQ(respond.exit_code, 0) << respond.errors;
  for (const std::string load : {"shear", "bulk"}) {
    const auto before = read_curve(study.result("curves.csv"), "A", load);
    const auto after = read_curve(study.result("respond-same/curves.csv"), "A", load);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i].modulus / before[i].modulus, 1.0, 1e-9);
  }
}

TEST(Space, AListOfTheSpheresOfAPackingIsTheSamePacking) {
  constexpr std::string_view packed = R"(
[[stages]]
name    = "A"
matrix  = "rubber"
box     = "1 mm"
cells   = 8
filler  = { material = "glass", fraction = 0.25, gap = "60 um", sizes = { diameter = "0.45 mm" } }
packing = { method = "lubachevsky-stillinger", walls = false }
)";
  StudyDirectory random(fmt::format("{}{}{}", materials, packed, tests));
  const auto run = random.breccia("run", {"--set", "tests.loads=[\"shear\"]"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  constexpr std::string_view listed = R"(
[[stages]]
name    = "A"
matrix  = "rubber"
box     = "1 mm"
cells   = 8
filler  = { material = "glass" }
packing = { method = "explicit", particles = "spheres.csv", walls = false }
)";
  StudyDirectory again(fmt::format("{}{}{}", materials, listed, tests));
  again.write("spheres.csv", read_text(random.result("A/microstructure.csv")));
  ASSERT_EQ(again.breccia("run", {"--set", "tests.loads=[\"shear\"]"}).exit_code, 0);
  EXPECT_EQ(read_text(again.result("curves.csv")), read_text(random.result("curves.csv")));
}

}  // namespace
}  // namespace breccia
