#include "homogenisation/plan/cell_memory.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "homogenisation/plan/measured_costs.hpp"

namespace breccia {
namespace {

Study box_of_matrix(int cells) {
  Study study;
  Stage stage;
  stage.name = "A";
  stage.matrix = Material{"matrix", 1e3, PronySeries(1e9), PronySeries(1e5, {{1e-2, 1e6}, {1e-3, 1e6}})};
  stage.side = 1e-3;
  stage.cells = cells;
  study.stages = {stage};
  study.tests.first_time = 1e-3;
  study.tests.last_time = 1e-2;
  return study;
}

// The measured memory of runs of HB-1 of PBX-9501 without fields (docs/performance.md): by the direct method, and on
// substructures.
TEST(CellMemory, IsNotLessThanThatOfMeasuredRuns) {
  const auto small = box_of_matrix(256), large = box_of_matrix(2000);
  EXPECT_GT(quasistatic_memory(small, small.stages.front(), 256), 0.26e9);
  EXPECT_GT(quasistatic_memory(large, large.stages.front(), 2000), 2.69e9);
}

// The smallest box takes little more than the program itself.
TEST(CellMemory, IsNeverLessThanThatOfTheProgram) {
  const auto study = box_of_matrix(2);
  EXPECT_GT(quasistatic_memory(study, study.stages.front(), 2), measured_costs::program);
}

TEST(CellMemory, GrowsWithTheCells) {
  for (const StagePacking& packing : {StagePacking(PackingMethod<2>()), StagePacking(PackingMethod<3>())}) {
    for (const auto method : {LinearMethod::direct, LinearMethod::iterative}) {
      auto study = box_of_matrix(16);
      auto& stage = study.stages.front();
      stage.packing = packing;
      study.tests.quasistatic.linear.method = method;
      double last = 0.0;
      for (const int cells : {16, 17, 32, 64, 128, 256, 512, 1024}) {
        const double bytes = quasistatic_memory(study, stage, cells);
        EXPECT_GT(bytes, last) << cells << " cells in " << stage.dimensions() << " dimensions";
        last = bytes;
      }
    }
  }
}

// Stepping has two nodal vectors of eight bytes for each of the two terms of the matrix and each load: one for the fine
// run and one for the coarse run.
TEST(CellMemory, OfSteppingGrowsWithTheTermsAndTheLoads) {
  auto study = box_of_matrix(100);
  study.tests.loads = {Load::shear, Load::diagonal_shear, Load::bulk};
  const auto& stage = study.stages.front();
  const double reduced = quasistatic_memory(study, stage, 100);
  study.tests.quasistatic.solver = Solver::stepping;
  const double stepping = quasistatic_memory(study, stage, 100);
  EXPECT_NEAR((stepping - reduced) / (2.0 * 100.0 * 100.0), 2.0 * 8.0 * 2.0 * 3.0, 1e-6);
  study.tests.loads.pop_back();
  EXPECT_NEAR((quasistatic_memory(study, stage, 100) - reduced) / (2.0 * 100.0 * 100.0), 2.0 * 8.0 * 2.0 * 2.0, 1e-6);
}

TEST(CellMemory, OfFieldsIsThatOfTheSolutionOnceMore) {
  auto study = box_of_matrix(2000);
  const auto beside_the_program = [&study] {
    return quasistatic_memory(study, study.stages.front(), 2000) - measured_costs::program;
  };
  const double without = beside_the_program();
  study.tests.field_times = {1e-2};
  EXPECT_NEAR(beside_the_program() / without, 2.0, 1e-12);
}

Study cube_of(double aspect) {
  auto study = box_of_matrix(64);
  auto& stage = study.stages.front();
  stage.packing = PackingMethod<3>();
  Filler filler;
  filler.material = {"filler", 1e3, PronySeries(1e10), PronySeries(1e10)};
  filler.fraction = 0.2;
  filler.sizes = SingleSize{1e-4};
  filler.shape = FillerShape{EllipticOutline{aspect}};
  stage.fillers = {filler};
  return study;
}

// Each of three nodal vectors has 18 strains of a phase in 3/2 cells per h^2 of the interface.
TEST(CellMemory, OfFlatEllipsoidsHasTheStrainsInTheirLargerInterface) {
  const auto spheres = cube_of(1.0), flat = cube_of(0.1);
  const double unknowns = 3.0 * 64 * 64 * 64, h = 1e-3 / 64;
  // An oblate ellipsoid of aspect c / a has the surface 2 pi a^2 (1 + (1 - e^2) / e artanh e), e^2 = 1 - (c / a)^2.
  const double e = std::sqrt(1.0 - 0.01), over_sphere = 0.5 * std::cbrt(100.0) * (1.0 + 0.01 / e * std::atanh(e));
  const double more = 3.0 * 8.0 * 18.0 / 3.0 * 1.5 * h * 0.2 * 6.0 / 1e-4 * (over_sphere - 1.0);
  EXPECT_NEAR(
      (quasistatic_memory(flat, flat.stages.front(), 64) - quasistatic_memory(spheres, spheres.stages.front(), 64)) /
          unknowns,
      more, 1e-9 * more);
}

}  // namespace
}  // namespace breccia
