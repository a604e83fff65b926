#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/deck/read_study.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"

#include "results/microstructure_files.hpp"
#include "results/result_files.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

constexpr auto materials = R"(
[materials.binder]
density = "1.48 g/cm^3"
bulk = "3.6 GPa"
shear = "1 MPa"
[materials.hmx]
density = "1.85 g/cm^3"
bulk = "13.4 GPa"
shear = "5.84 GPa"
[tests]
loads = ["shear"]
times = ["10 ns", "10 ms"]
[[stages]]
name = "a"
matrix = "binder"
box = "6 mm"
cells = 60
)";

/// The stage of a deck with these lines, written into a directory.
Stage stage_of(const test::TemporaryDirectory& directory, const std::string& lines) {
  return read_study(directory.written("deck.toml", materials + lines)).stages.at(0);
}

TEST(ParticleFiles, AreAnExplicitPackingWithTheSamePoints) {
  const test::TemporaryDirectory directory;
  directory.write("grain.csv", "x_mm,y_mm\n0,0\n3,0\n4,2\n1,3\n");
  const auto stage = stage_of(directory, R"(
packing = { method = "random-sequential", walls = false, seed = 5 }
[[stages.filler]]
material = "hmx"
fraction = 0.3
sizes = { diameter = "0.8 mm" }
shape = { aspect = 1.8 }
[[stages.filler]]
material = "hmx"
fraction = 0.2
sizes = { diameter = "0.6 mm" }
shape = { polygon = "grain.csv" }
coating = { material = "binder", thickness = "20 um" }
)");
  const auto packed = make_microstructure(stage);
  write_microstructure(directory.path(), stage, packed);
  for (const auto* name : {"microstructure.csv", "polygons.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(directory.path() / name) && is_file_of_a_stage(name)) << name;
  }
  const auto listed_stage = stage_of(directory, R"(
packing = { method = "explicit", walls = false, particles = "microstructure.csv", polygons = "polygons.csv" }
[[stages.filler]]
material = "hmx"
[[stages.filler]]
material = "hmx"
coating = { material = "binder", thickness = "20 um" }
)");
  const auto listed = make_microstructure(listed_stage);
  EXPECT_EQ(listed.particles(), packed.particles());
  EXPECT_NEAR(listed.gap, packed.gap, 1e-15);
  for (const auto mixing : {Mixing::points, Mixing::series}) {
    const auto again = discretise(listed_stage, listed, 60, mixing), before = discretise(stage, packed, 60, mixing);
    EXPECT_TRUE(
        std::ranges::equal(std::get<Discretisation<2>>(again).cells(), std::get<Discretisation<2>>(before).cells()));
  }
}

}  // namespace
}  // namespace breccia
