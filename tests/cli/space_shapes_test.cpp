// Tests of grains, stacks of images and ellipsoids in three dimensions through the command line.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/rasters/raster_reader.hpp"

#include "io/text_file.hpp"
#include "rasters/npy.hpp"
#include "report/embedded_pictures.hpp"
#include "study_directory.hpp"

namespace breccia::shapes_in_space {
namespace {

using test::read_curve;
using test::StudyDirectory;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

/// An elastic rubber: its laminates and extrusions have exact moduli.
constexpr std::string_view materials = R"(
[materials.rubber]
density = "1.1 g/cm^3"
bulk    = "2 GPa"
shear   = "100 MPa"
[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"
)";

constexpr std::string_view tests = R"(
[tests]
times  = ["10 us", "100 us"]
points_per_decade = 1
)";

/// A stage of a cube of 1 mm with a matrix of rubber.
std::string deck_of(std::string_view keys, std::string_view more_tests = "loads = [\"shear\", \"bulk\"]\n") {
  return fmt::format("dimensions = 3\n{}\n[[stages]]\nname = \"A\"\nmatrix = \"rubber\"\n{}\n{}{}", materials, keys,
                     tests, more_tests);
}

/// Four sites of a face-centred cubic lattice, whose cells are rhombic dodecahedra.
constexpr std::string_view face_centred = "x_mm,y_mm,z_mm\n0.1,0.1,0.1\n0.6,0.6,0.1\n0.6,0.1,0.6\n0.1,0.6,0.6\n";

std::string grains(std::string_view amount, std::string_view packing, int cells = 8) {
  return fmt::format(
      "box = \"1 mm\"\ncells = {}\nfiller = {{ material = \"glass\"{} }}\n"
      "packing = {{ method = \"laguerre\", {} }}\n",
      cells, amount, packing);
}

Json stage_of(const StudyDirectory& study) {
  return Json::parse(read_text(study.result("study.json")))["stages"][0];
}

double modulus(const StudyDirectory& study, const std::string& load) {
  return read_curve(study.result("curves.csv"), "A", load).at(0).modulus;
}

TEST(SpaceGrains, RhombicDodecahedraHaveTheirExactFraction) {
  StudyDirectory study(deck_of(grains("", R"(sites = "fcc.csv", film = "0.1 mm")", 12)));
  study.write("fcc.csv", face_centred);
  const auto check = study.breccia("check");
  ASSERT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(
      check.output,
      AllOf(HasSubstr("Laguerre tessellation, periodic"), HasSubstr("4 sites, films of 100 um"),
            HasSubstr("  A: 1.2 cells across a film, the error of the grid may be of any size; cells = 25 for 5 %")));
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("4 grains fill"), HasSubstr("films of 100 um (1.2 cells)")));
  // All faces are at half the distance of nearest sites, so that films take the same share of every length.
  const double left = 1.0 - 0.1 * std::sqrt(2.0), fraction = left * left * left;
  const auto stage = stage_of(study);
  EXPECT_NEAR(stage["microstructure"]["fraction"].get<double>(), fraction, 1e-12);
  EXPECT_NEAR(stage["filler_point_fraction"].get<double>(), fraction, 2e-3) << "mixtures are rounded";
  EXPECT_NEAR(stage["microstructure"]["film_cells"].get<double>(), 1.2, 1e-12);
  // A dodecahedron around a ball of radius r has the surface 12 sqrt(2) r^2; here r is (1 - 0.1 sqrt(2)) sqrt(2) / 4.
  const double radius = left * std::sqrt(2.0) / 4.0, surface = 4.0 * 12.0 * std::sqrt(2.0) * radius * radius / 1e-3;
  EXPECT_NEAR(stage["microstructure"]["interface_per_volume_1_per_m"].get<double>() / surface, 1.0, 1e-9);
  EXPECT_THAT(study.results(), AllOf(Contains("A/cut-x.svg"), Contains("A/cut-y.svg"), Contains("A/microstructure.svg"),
                                     Contains("A/labels.vti"), Contains("A/response.h5")));
  EXPECT_THAT(read_text(study.result("A/grains.csv")),
              HasSubstr("x_m,y_m,z_m,weight_m2,cell_volume_m3,grain_volume_m3,equivalent_diameter_m,"));
  EXPECT_THAT(read_text(study.result("A/cut-x.svg")), HasSubstr("cut through the middle of 4 grains, seen along x"));
  EXPECT_THAT(read_raster(study.result("A/labels.vti"), "grain").extents, ElementsAre(24, 24, 24));
  const double shear = modulus(study, "shear");
  EXPECT_GT(shear, 100e6);
  EXPECT_LT(shear, 30e9);
}

TEST(SpaceGrains, ListedSitesOfRandomGrainsAreTheSameGrains) {
  StudyDirectory random(deck_of(fmt::format(
      "box = \"1 mm\"\ncells = 8\npacking = {{ method = \"laguerre\", seed = 7 }}\n[stages.filler]\nmaterial = "
      "\"glass\"\nfraction = 0.7\nsizes = {{ lognormal = [{{ median = \"0.5 mm\", sigma = 0.3 }}] }}\nfrom = \"0.3 "
      "mm\"\nto = \"0.7 mm\"\n")));
  const auto run = random.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto stage = stage_of(random);
  EXPECT_NEAR(stage["microstructure"]["fraction"].get<double>(), 0.7, 1e-9);
  StudyDirectory again(deck_of(grains(", fraction = 0.7", "sites = \"grains.csv\"")));
  again.write("grains.csv", read_text(random.result("A/grains.csv")));
  const auto rerun = again.breccia("run");
  ASSERT_EQ(rerun.exit_code, 0) << rerun.errors;
  EXPECT_EQ(read_text(again.result("A/grains.csv")), read_text(random.result("A/grains.csv")));
  EXPECT_EQ(read_text(again.result("curves.csv")), read_text(random.result("curves.csv")));
}

TEST(SpaceGrains, GoOnFromTheirState) {
  const auto deck = deck_of(grains(R"(, sizes = { diameter = "0.5 mm" })", "film = \"50 um\", seed = 2"));
  StudyDirectory whole(deck), parts(deck);
  ASSERT_EQ(whole.breccia("run").exit_code, 0);
  ASSERT_EQ(parts.breccia("pack").exit_code, 0);
  const auto before = read_text(parts.result("A/grains.csv"));
  const auto run = parts.breccia("run", {"--resume"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(read_text(parts.result("A/grains.csv")), before);
  EXPECT_EQ(read_text(parts.result("curves.csv")), read_text(whole.result("curves.csv")));
}

TEST(SpaceGrains, HaveWallsAsInThePlane) {
  StudyDirectory cut(deck_of(grains("", R"(sites = "fcc.csv", film = "50 um", walls = "cut")")));
  cut.write("fcc.csv", face_centred);
  const auto run = cut.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, AllOf(HasSubstr("upper"), HasSubstr("lower")));
  const auto with_film =
      cut.breccia("check", {"--set", "stages.0.packing.walls=true", "--set", "tests.boundaries=[\"traction\"]"});
  EXPECT_EQ(with_film.exit_code, 2);
  EXPECT_THAT(with_film.errors, HasSubstr("films along the walls: expected the boundary \"displacement\" alone"));
  const auto thick = cut.breccia("run", {"--set", "stages.0.packing.film=2 mm", "--overwrite"});
  EXPECT_NE(thick.exit_code, 0);
  EXPECT_THAT(thick.errors, HasSubstr("films of 2 mm leave nothing of any grain"));
}

/// A cube of 8 voxels a side with an odd number where `is_glass(x, y, z)`.
template <class IsGlass>
std::vector<std::uint16_t> voxels(std::size_t along, IsGlass&& is_glass) {
  std::vector<std::uint16_t> labels;
  for (std::size_t z = 0; z < along; ++z) {
    for (std::size_t y = 0; y < along; ++y) {
      for (std::size_t x = 0; x < along; ++x) labels.push_back(is_glass(x, y, z) ? 1 : 0);
    }
  }
  return labels;
}

constexpr std::string_view labels =
    R"(labels = [{ value = 0, material = "rubber" }, { value = 1, material = "glass" }])";

std::string stack(std::string_view file) {
  return fmt::format("packing = {{ method = \"image\", file = \"{}\", pixel = \"10 um\", periodic = true, {} }}\n",
                     file, labels);
}

TEST(SpaceImages, LayersAreExact) {
  StudyDirectory study(deck_of(stack("layers.npy"), "loads = [\"shear\", \"shear-yz\", \"shear-zx\"]\n"));
  const std::vector<std::size_t> extents = {8, 8, 8};
  write_npy(study.path() / "layers.npy", extents, voxels(8, [](auto, auto, auto z) { return z < 2; }));
  const auto check = study.breccia("check");
  EXPECT_THAT(check.output, AllOf(HasSubstr("layers.npy, 8 x 8 x 8 voxels of 10 um, periodic"),
                                  HasSubstr("4 x 4 x 4 cells of 20 um")));
  const auto run = study.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("voxels of the filler fill 25.00 %"));
  EXPECT_NEAR(modulus(study, "shear") / (0.25 * 30e9 + 0.75 * 100e6), 1.0, 1e-6);
  const double harmonic = 1.0 / (0.25 / 30e9 + 0.75 / 100e6);
  EXPECT_NEAR(modulus(study, "shear-yz") / harmonic, 1.0, 1e-6);
  EXPECT_NEAR(modulus(study, "shear-zx") / harmonic, 1.0, 1e-6);
  const auto stage = stage_of(study);
  EXPECT_EQ(stage["microstructure"]["pixels"], Json({8, 8, 8}));
  EXPECT_TRUE(stage["microstructure"]["particles"].is_null());
  EXPECT_NEAR(stage["microstructure"]["interface_per_volume_1_per_m"].get<double>(), 2.0 / 80e-6, 1e-6);
  EXPECT_THAT(study.results(), AllOf(Contains("A/cut-x.svg"), Contains("A/cut-y.svg"), Contains("A/microstructure.svg"),
                                     Contains("A/labels.npy")));
}

/// The bytes of a NumPy array of 8 x 8 x 8, indexed [z][y][x] with the top row first, which is one where a function of
/// the voxel is true.
template <class IsGlass>
std::string numpy_array(const IsGlass& is_glass) {
  std::string header = "{'descr': '|u1', 'fortran_order': False, 'shape': (8, 8, 8), }";
  header.resize(117, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += {'\x01', '\x00', static_cast<char>(header.size()), '\x00'};
  bytes += header;
  for (int z = 0; z < 8; ++z) {
    for (int y = 7; y >= 0; --y) {
      for (int x = 0; x < 8; ++x) bytes += static_cast<char>(is_glass(x, y, z) ? 1 : 0);
    }
  }
  return bytes;
}

// Layers are stiff along themselves and soft across: the load that does not shear them shows the direction of their
// normal.
TEST(SpaceImages, LayersHaveTheNormalOfTheirFile) {
  const double harmonic = 1.0 / (0.25 / 30e9 + 0.75 / 100e6), mean = 0.25 * 30e9 + 0.75 * 100e6;
  StudyDirectory study(deck_of(stack("layers.npy"), "loads = [\"shear\", \"shear-yz\", \"shear-zx\"]\n"));
  study.write("layers.npy", numpy_array([](int x, int /*y*/, int /*z*/) { return x < 2; }));
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  EXPECT_NEAR(modulus(study, "shear-yz") / mean, 1.0, 1e-6);
  for (const auto* load : {"shear", "shear-zx"}) EXPECT_NEAR(modulus(study, load) / harmonic, 1.0, 1e-6) << load;
  study.write("layers.npy", numpy_array([](int /*x*/, int y, int /*z*/) { return y < 2; }));
  ASSERT_EQ(study.breccia("run", {"--overwrite"}).exit_code, 0);
  EXPECT_NEAR(modulus(study, "shear-zx") / mean, 1.0, 1e-6);
  for (const auto* load : {"shear", "shear-yz"}) EXPECT_NEAR(modulus(study, load) / harmonic, 1.0, 1e-6) << load;
}

// The body has no symmetry, so that its three middle planes, and the labels of its points, are all different.
TEST(SpaceImages, PicturesShowTheMiddlePlanes) {
  const auto is_glass = [](int x, int y, int z) { return x + 2 * y < 9 && (z > 2 || x == 4) && (x + z) % 3 != 0; };
  StudyDirectory study(deck_of(stack("body.npy")));
  study.write("body.npy", numpy_array(is_glass));
  const auto pack = study.breccia("pack");
  ASSERT_EQ(pack.exit_code, 0) << pack.errors;
  const auto shown = [&](const std::string& file, int across, int up) {
    const auto pictures = test::embedded_pictures(read_text(study.result("A/" + file)));
    const auto& plane = pictures.at(0);
    // The pixel in the middle of a voxel.
    const auto pixel = [&](int voxel, std::size_t axis) {
      return (2 * static_cast<std::size_t>(voxel) + 1) * plane.extents[axis] / 16;
    };
    return plane.values[pixel(up, 1) * plane.extents[0] + pixel(across, 0)];
  };
  const auto points = read_raster(study.result("A/labels.vti"), "phase");
  ASSERT_THAT(points.extents, ElementsAre(8, 8, 8));
  for (int a = 0; a < 8; ++a) {
    for (int b = 0; b < 8; ++b) {
      EXPECT_EQ(shown("microstructure.svg", a, b), is_glass(a, b, 4)) << "seen along z " << a << " " << b;
      EXPECT_EQ(shown("cut-x.svg", a, b), is_glass(4, a, b)) << "seen along x " << a << " " << b;
      EXPECT_EQ(shown("cut-y.svg", a, b), is_glass(b, 4, a)) << "seen along y " << a << " " << b;
      EXPECT_EQ(points.values[static_cast<std::size_t>(64 * 3 + 8 * a + b)], is_glass(b, a, 3)) << a << " " << b;
    }
  }
}

TEST(SpaceImages, ExtrudedAlongZHaveTheModuliOfThePlane) {
  // The test uses standard volumetric strains, because averaged ones are those of a cell and differ between a square
  // and a cube.
  constexpr auto standard = "loads = [\"shear\", \"shear-xx-yy\"]\nmixing = \"points\"\nvolumetric = \"standard\"\n";
  const auto is_glass = [](std::size_t x, std::size_t y) { return (x > 1 && x < 5 && y > 2) || (x == 6 && y < 3); };
  StudyDirectory space(deck_of(stack("image.npy"), standard));
  write_npy(space.path() / "image.npy", std::vector<std::size_t>{8, 8, 8},
            voxels(8, [&](auto x, auto y, auto) { return is_glass(x, y); }));
  ASSERT_EQ(space.breccia("run").exit_code, 0);
  StudyDirectory plane(deck_of(stack("image.npy"), standard));
  std::vector<std::uint16_t> pixels;
  for (std::size_t y = 0; y < 8; ++y) {
    for (std::size_t x = 0; x < 8; ++x) pixels.push_back(is_glass(x, y) ? 1 : 0);
  }
  write_npy(plane.path() / "image.npy", std::vector<std::size_t>{8, 8}, pixels);
  const auto run = plane.breccia("run", {"--set", "dimensions=2"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  for (const auto* load : {"shear", "shear-xx-yy"}) {
    EXPECT_NEAR(modulus(space, load) / modulus(plane, load), 1.0, 1e-6) << load;
  }
}

TEST(SpaceImages, LabelsOfAnyRunAreAnImage) {
  constexpr auto points = "loads = [\"shear\"]\nmixing = \"points\"\n";
  StudyDirectory first(deck_of(grains("", R"(sites = "fcc.csv", film = "0.15 mm")"), points));
  first.write("fcc.csv", face_centred);
  ASSERT_EQ(first.breccia("run").exit_code, 0);
  for (const std::string file : {"labels.npy", "labels.vti"}) {
    const auto name = file == "labels.vti" ? file + ":/phase" : file;
    StudyDirectory again(deck_of(fmt::format("box = \"1 mm\"\npacking = {{ method = \"image\", file = \"{}\", "
                                             "periodic = true, {} }}\n",
                                             name, labels),
                                 points));
    std::filesystem::copy_file(first.result("A/" + file), again.path() / file);
    const auto run = again.breccia("run");
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(read_text(again.result("curves.csv")), read_text(first.result("curves.csv"))) << file;
  }
}

constexpr std::string_view angles = "x_mm,y_mm,z_mm,axis_1_mm,axis_2_mm,axis_3_mm,azimuth_deg,elevation_deg,roll_deg\n";

std::string listed(std::string_view coating = "") {
  return fmt::format(
      "box = \"1 mm\"\ncells = 8\nfiller = {{ material = \"glass\"{} }}\npacking = {{ method = "
      "\"explicit\", particles = \"particles.csv\", walls = false }}\n",
      coating);
}

TEST(SpaceEllipsoids, WithEqualAxesAreSpheres) {
  StudyDirectory ellipsoids(deck_of(listed())), spheres(deck_of(listed()));
  ellipsoids.write("particles.csv", fmt::format("{}0.4,0.5,0.6,0.7,0.7,0.7,20,30,40\n", angles));
  spheres.write("particles.csv", "x_mm,y_mm,z_mm,diameter_mm\n0.4,0.5,0.6,0.7\n");
  ASSERT_EQ(ellipsoids.breccia("run").exit_code, 0);
  ASSERT_EQ(spheres.breccia("run").exit_code, 0);
  for (const auto* file : {"curves.csv", "A/microstructure.csv", "A/labels.npy"}) {
    EXPECT_EQ(read_text(ellipsoids.result(file)), read_text(spheres.result(file))) << file;
  }
}

TEST(SpaceEllipsoids, TurnWithTheirModuli) {
  constexpr auto loads = "loads = [\"shear\", \"shear-yz\", \"shear-zx\", \"shear-xx-yy\", \"shear-yy-zz\"]\n";
  // The longest axis is along x and the next along y; the second body is turned so that x becomes y, y becomes z, and z
  // becomes x.
  StudyDirectory before(deck_of(listed(), loads)), after(deck_of(listed(), loads));
  before.write("particles.csv", fmt::format("{}0.5,0.5,0.5,0.9,0.6,0.4,0,0,0\n", angles));
  after.write("particles.csv", fmt::format("{}0.5,0.5,0.5,0.9,0.6,0.4,90,0,90\n", angles));
  const auto run = before.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  ASSERT_EQ(after.breccia("run").exit_code, 0);
  const double fraction = 3.14159265358979 / 6.0 * 0.9 * 0.6 * 0.4;
  const auto stage = stage_of(before);
  EXPECT_NEAR(stage["microstructure"]["fraction"].get<double>(), fraction, 1e-12);
  EXPECT_NEAR(stage["filler_point_fraction"].get<double>(), fraction, 5e-3) << "by parts of cells";
  EXPECT_NEAR(modulus(after, "shear-yz") / modulus(before, "shear"), 1.0, 1e-5);
  EXPECT_NEAR(modulus(after, "shear-zx") / modulus(before, "shear-yz"), 1.0, 1e-5);
  EXPECT_NEAR(modulus(after, "shear") / modulus(before, "shear-zx"), 1.0, 1e-5);
  EXPECT_NEAR(modulus(after, "shear-yy-zz") / modulus(before, "shear-xx-yy"), 1.0, 1e-5);
  EXPECT_GT(std::abs(modulus(before, "shear") / modulus(before, "shear-yz") - 1.0), 0.01) << "they do differ";
}

TEST(SpaceEllipsoids, AtRandomAreReadBack) {
  constexpr auto coating = R"(, coating = { material = "rubber2", thickness = "20 um" })";
  const auto with_coating = [](std::string deck) {
    return deck.insert(deck.find("[materials.glass]"),
                       "[materials.rubber2]\ndensity = \"1.1 g/cm^3\"\nbulk = \"3 GPa\"\nshear = \"500 MPa\"\n");
  };
  const auto deck = with_coating(deck_of(fmt::format(
      "box = \"1 mm\"\ncells = 8\nfiller = {{ material = \"glass\", fraction = 0.2, gap = \"20 um\", sizes = {{ "
      "diameter = \"0.4 mm\" }}, shape = {{ aspect = 2 }}{} }}\npacking = {{ method = \"random-sequential\", walls = "
      "false, seed = 3 }}\n",
      coating)));
  StudyDirectory random(deck), parts(deck);
  const auto check = random.breccia("check");
  EXPECT_THAT(check.output, AllOf(HasSubstr("shape    ellipsoids of revolution of aspect 2"),
                                  HasSubstr("random sequential, periodic, seed 3")));
  const auto run = random.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto stage = stage_of(random);
  // There are six ellipsoids, whose volume is nearest to the fraction.
  EXPECT_NEAR(stage["microstructure"]["fraction"].get<double>(), 3.14159265358979 * 0.4 * 0.4 * 0.4, 1e-12);
  EXPECT_GE(stage["microstructure"]["smallest_gap_m"].get<double>(), 20e-6);
  EXPECT_NEAR(stage["microstructure"]["largest_diameter_m"].get<double>(), 0.4e-3, 0.02e-3);
  EXPECT_GT(stage["fillers"][0]["coating"]["fraction"].get<double>(), 0.05);
  EXPECT_THAT(random.results(), AllOf(Contains("A/cut-x.svg"), Contains("A/cut-y.svg"), Contains("A/labels.vti")));

  ASSERT_EQ(parts.breccia("pack").exit_code, 0);
  ASSERT_EQ(parts.breccia("run", {"--resume"}).exit_code, 0);
  EXPECT_EQ(read_text(parts.result("curves.csv")), read_text(random.result("curves.csv")));

  StudyDirectory again(with_coating(deck_of(listed(coating))));
  again.write("particles.csv", read_text(random.result("A/microstructure.csv")));
  const auto rerun = again.breccia("run");
  ASSERT_EQ(rerun.exit_code, 0) << rerun.errors;
  EXPECT_NEAR(modulus(again, "shear") / modulus(random, "shear"), 1.0, 1e-6);
}

TEST(SpaceEllipsoids, ThatJamAreExplained) {
  StudyDirectory study(
      deck_of("box = \"1 mm\"\ncells = 8\nfiller = { material = \"glass\", fraction = 0.75, gap = \"20 um\", sizes = { "
              "diameter = \"0.6 mm\" }, shape = { aspect = 2 } }\npacking = { method = \"random-sequential\", walls = "
              "false }\n"));
  const auto run = study.breccia("run");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("diameters of balls of equal volume"), HasSubstr("they are stuck at")));
}

}  // namespace
}  // namespace breccia::shapes_in_space
