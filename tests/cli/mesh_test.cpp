// Tests of `breccia mesh`: surfaces and meshes of packed boxes are read back by parsers of their own.

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "results/mesh_parsers.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr std::string_view materials = R"(
[materials.rubber]
density = "1.1 g/cm^3"
bulk    = "2 GPa"
shear   = "100 MPa"
[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"
[materials.salt]
density = "2 g/cm^3"
bulk    = "20 GPa"
shear   = "10 GPa"
[tests]
times = ["1 us", "1 s"]
loads = ["shear"]
fields = "none"
)";

/// A deck with one stage, of a box of 1 mm.
std::string deck(int dimensions, std::string_view stage, std::string_view more_tests = "") {
  return fmt::format("dimensions = {}\n{}{}\n[[stages]]\nname = \"A\"\nmatrix = \"rubber\"\nbox = \"1 mm\"\n{}",
                     dimensions, materials, more_tests, stage);
}

constexpr std::string_view two_fillers = R"(
cells   = 8
packing = { method = "random-sequential", seed = 3 }
[[stages.filler]]
material = "glass"
fraction = 0.15
sizes    = { diameter = "0.3 mm" }
[[stages.filler]]
material = "salt"
fraction = 0.1
sizes    = { diameter = "0.25 mm" }
shape    = { aspect = 1.5 }
)";

constexpr std::string_view grains_of_glass = R"(
cells   = 8
filler  = { material = "glass", fraction = 0.9, sizes = { from = "0.4 mm", to = "0.6 mm" } }
packing = { method = "laguerre", seed = 3 }
)";

/// A study that is packed when it is made.
class PackedStudy : public StudyDirectory {
 public:
  explicit PackedStudy(const std::string& deck) : StudyDirectory(deck) {
    const auto packed = breccia("pack");
    EXPECT_EQ(packed.exit_code, 0) << packed.errors;
  }
  [[nodiscard]] Outcome mesh(std::vector<std::string> more) const {
    more.insert(more.begin(), {"mesh", "out", "--format"});
    return run_breccia(path(), more);
  }
  /// The microstructure in the record of the stage.
  [[nodiscard]] nlohmann::json record() const {
    return nlohmann::json::parse(read_text(result("study.json")))["stages"][0];
  }
  [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(path() / name); }
};

TEST(Mesh, HasTheSurfacesOfSpheresAndEllipsoids) {
  const PackedStudy study(deck(3, two_fillers));
  const auto written = study.mesh({"stl", "--output", "a.stl", "--units", "mm", "--resolution", "5 %"});
  ASSERT_EQ(written.exit_code, 0) << written.errors;
  const auto table = read_csv(study.result("A/microstructure.csv"));
  EXPECT_THAT(written.output,
              AllOf(HasSubstr(fmt::format("A: the surfaces of {} particles", table.rows())), HasSubstr("lengths in mm"),
                    HasSubstr("are whole, at their place"), HasSubstr("The surfaces are in a.stl")));
  const auto bodies = closed_bodies(parse_stl(read_text(study.path() / "a.stl")));
  ASSERT_EQ(bodies.size(), table.rows());
  double sum = 0.0;
  for (std::size_t row = 0; row < bodies.size(); ++row) {
    double exact = 1e9 * std::numbers::pi / 6.0;  // in mm^3
    for (const auto* axis : {"axis_1_m", "axis_2_m", "axis_3_m"}) exact *= table.numbers(axis)[row];
    EXPECT_NEAR(volume_of(bodies[row]) / exact, 1.0, 0.004);
    EXPECT_LT(volume_of(bodies[row]), exact) << "the corners are on the particles";
    sum += volume_of(bodies[row]);
    const Point centre = {1e3 * table.numbers("x_m")[row], 1e3 * table.numbers("y_m")[row],
                          1e3 * table.numbers("z_m")[row]};
    for (const auto& [normal, corners] : bodies[row]) {
      double height = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) height += normal[axis] * (corners[0][axis] - centre[axis]);
      EXPECT_GT(height, 0.0) << "normals point outwards";
    }
  }
  EXPECT_NEAR(sum, study.record()["microstructure"]["fraction"].get<double>(), 0.002);
}

TEST(Mesh, HasTheSurfacesOfOneMaterial) {
  const PackedStudy study(deck(3, two_fillers));
  const auto written = study.mesh({"stl", "--output", "a.stl", "--material", "salt"});
  ASSERT_EQ(written.exit_code, 0) << written.errors;
  const auto bodies = closed_bodies(parse_stl(read_text(study.path() / "a.stl")));
  EXPECT_EQ(bodies.size(), study.record()["fillers"][1]["particles"].get<std::size_t>());
  const auto refused = study.mesh({"stl", "--output", "b.stl", "--material", "slat"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("stage A has no particles of \"slat\", did you mean \"salt\"?"));
  EXPECT_FALSE(study.has("b.stl"));
}

TEST(Mesh, OfGrainsInSpaceHasTheirFraction) {
  const PackedStudy study(deck(3, grains_of_glass));
  const auto surfaces = study.mesh({"stl", "--output", "a.stl"});
  ASSERT_EQ(surfaces.exit_code, 0) << surfaces.errors;
  const auto grains = read_csv(study.result("A/grains.csv"));
  const auto bodies = closed_bodies(parse_stl(read_text(study.path() / "a.stl")));
  ASSERT_EQ(bodies.size(), grains.rows());
  for (std::size_t row = 0; row < bodies.size(); ++row) {
    EXPECT_NEAR(volume_of(bodies[row]) / grains.numbers("grain_volume_m3")[row], 1.0, 1e-5) << "of single precision";
  }
  const auto written = study.mesh({"msh", "--output", "a.msh", "--layers", "2", "--divisions", "1", "--units", "mm"});
  ASSERT_EQ(written.exit_code, 0) << written.errors;
  EXPECT_EQ(written.errors, "");
  const auto msh = parse_msh(read_text(study.path() / "a.msh"));
  EXPECT_NEAR(msh.content("glass"), 0.9, 1e-9);
  EXPECT_NEAR(msh.content("glass") + msh.content("rubber"), 1.0, 1e-6) << "from where on the command warns of overlaps";
  std::set<int> entities;
  for (const auto& element : msh.of_group("glass")) {
    entities.insert(element.entity);
    EXPECT_GT(msh.content(element), 0.0);
  }
  EXPECT_EQ(entities.size(), grains.rows());
  EXPECT_EQ(msh.of_group("rubber").at(0).entity, static_cast<int>(grains.rows()) + 1);
  ASSERT_GE(msh.periodic.size(), 3U);
  for (const auto& pair : msh.periodic) {
    for (const auto& [node, master] : pair.nodes) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(msh.nodes.at(node)[axis], msh.nodes.at(master)[axis] + pair.affine[4 * axis + 3], 1e-12);
      }
    }
  }
}

TEST(Mesh, OfTestedFilmsInThePlaneHasTheirLayers) {
  const StudyDirectory study(
      deck(2, grains_of_glass, "model = \"films\"\nboundaries = [\"periodic\"]\nfilms = { layers = 2 }\n"));
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto mesh = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"mesh", "out", "--format"});
    return run_breccia(study.path(), more);
  };
  const auto written = mesh({"msh", "--output", "a.msh"}), coarse = mesh({"msh", "--output", "b.msh", "--layers", "1"});
  ASSERT_EQ(written.exit_code, 0) << written.errors;
  ASSERT_EQ(coarse.exit_code, 0) << coarse.errors;
  const auto msh = parse_msh(read_text(study.path() / "a.msh")), other = parse_msh(read_text(study.path() / "b.msh"));
  EXPECT_NEAR(1e6 * msh.content("glass"), 0.9, 1e-9);
  EXPECT_NEAR(1e6 * (msh.content("glass") + msh.content("rubber")), 1.0, 1e-9);
  EXPECT_LT(other.elements.size(), msh.elements.size());
  const auto for_paraview = mesh({"vtkhdf", "--output", "a.vtkhdf"});
  EXPECT_EQ(for_paraview.exit_code, 0) << for_paraview.errors;
  EXPECT_TRUE(std::filesystem::exists(study.path() / "a.vtkhdf"));
}

TEST(Mesh, ListsEveryMistakeAtOnceAndWritesNothing) {
  const PackedStudy study(deck(3, two_fillers));
  const auto refused = study.mesh({"stl", "--output", ".", "--resolution", "0.1 %", "--layers", "2", "--stage", "B"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors,
              AllOf(HasSubstr("--layers: the format stl has none"),
                    HasSubstr("--resolution: expected a share from 0.5 % to 100 %, got \"0.1 %\""),
                    HasSubstr("--output: expected a file, got the directory ."), HasSubstr("no stage \"B\"")));
  const auto format = study.mesh({"obj", "--output", "a.obj"});
  EXPECT_EQ(format.exit_code, 2);
  EXPECT_THAT(format.errors, HasSubstr("--format"));
  const auto cells = study.mesh({"msh", "--output", "a.msh"});
  EXPECT_EQ(cells.exit_code, 2);
  EXPECT_THAT(cells.errors,
              AllOf(HasSubstr("no grains that fill its box"), HasSubstr("A/labels.npy"), HasSubstr("stl")));
  const auto missing = run_breccia(study.path(), {"mesh", "nowhere", "--format", "stl", "--output", "a.stl"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.errors, HasSubstr("nowhere: no such directory"));
  const auto empty = run_breccia(study.path(), {"mesh", ".", "--format", "stl", "--output", "a.stl"});
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.errors, HasSubstr("no study.json"));
  EXPECT_FALSE(study.has("a.stl") || study.has("a.msh") || study.has("a.obj"));
}

TEST(Mesh, OfADamagedTableIsRefused) {
  const PackedStudy study(deck(3, two_fillers));
  const auto file = study.result("A/microstructure.csv");
  const auto whole = read_text(file);
  const auto refusal = [&](const std::string& text) {
    write_text(file, text);
    const auto refused = study.mesh({"stl", "--output", "a.stl"});
    EXPECT_EQ(refused.exit_code, 4);
    EXPECT_FALSE(study.has("a.stl"));
    return refused.errors;
  };
  const auto last_row = whole.rfind('\n', whole.size() - 2) + 1;
  EXPECT_THAT(refusal(whole.substr(0, last_row)), HasSubstr("particles"));
  const auto last_comma = whole.rfind(',');
  EXPECT_THAT(refusal(whole.substr(0, last_comma) + ",-1\n"), HasSubstr("expected a whole number from 0 to 1, got -1"));
}

TEST(Mesh, DoesNotReplaceAFileUnasked) {
  const PackedStudy study(deck(3, two_fillers));
  study.write("a.stl", "mine");
  const auto refused = study.mesh({"stl", "--output", "a.stl"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("--overwrite"));
  EXPECT_EQ(read_text(study.path() / "a.stl"), "mine");
  EXPECT_EQ(study.mesh({"stl", "--output", "a.stl", "--overwrite"}).exit_code, 0);
  EXPECT_NE(read_text(study.path() / "a.stl"), "mine");
}

TEST(Mesh, OfThePlaneHasNoSurfacesAndTakesLayers) {
  const PackedStudy study(deck(2, grains_of_glass));
  const auto surfaces = study.mesh({"stl", "--output", "a.stl"});
  EXPECT_EQ(surfaces.exit_code, 2);
  EXPECT_THAT(surfaces.errors, AllOf(HasSubstr("is in the plane"), HasSubstr("msh has the mesh")));
  const auto thin = study.mesh({"msh", "--output", "a.msh", "--divisions", "2"});
  EXPECT_EQ(thin.exit_code, 2);
  EXPECT_THAT(thin.errors, AllOf(HasSubstr("such as --layers 2"), HasSubstr("expected --face-share")));
  EXPECT_FALSE(study.has("a.stl") || study.has("a.msh"));
}

TEST(Mesh, OfGrainsAlongWallsIsRefused) {
  const PackedStudy study(deck(2, R"(
cells   = 8
filler  = { material = "glass", fraction = 0.9, sizes = { from = "0.4 mm", to = "0.6 mm" } }
packing = { method = "laguerre", seed = 3, walls = true }
)"));
  const auto refused = study.mesh({"msh", "--output", "a.msh", "--layers", "2"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("has walls"), HasSubstr("packing.walls = \"cut\"")));
  EXPECT_EQ(study.record()["microstructure"]["sides"], "hard");
}

}  // namespace
}  // namespace breccia::test
