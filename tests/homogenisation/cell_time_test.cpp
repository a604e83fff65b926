#include "homogenisation/plan/cell_time.hpp"

#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "homogenisation/plan/expected_snapshots.hpp"

namespace breccia {
namespace {

/// The deck examples/space/long-curve.toml.
Study long_curve() {
  std::vector<MaxwellTerm> terms;
  double time = 1e-9;
  for (const double modulus : {500e6, 250e6, 120e6, 60e6, 30e6, 15e6, 8e6, 4e6, 2e6}) {
    terms.push_back({time, modulus});
    time *= 100.0;
  }
  Stage stage;
  stage.name = "spheres";
  stage.packing = PackingMethod<3>();
  stage.matrix = Material{"rubber", 1e3, PronySeries(3600e6), PronySeries(1e6, terms)};
  stage.side = 1.0;
  stage.cells = 96;
  Filler filler;
  filler.material = {"filler", 1e3, PronySeries(13400e6), PronySeries(5840e6)};
  filler.fraction = 0.35;
  filler.sizes = SingleSize{0.281394};
  stage.fillers = {filler};
  Study study;
  study.stages = {stage};
  study.tests.first_time = 1e-10;
  study.tests.last_time = 1e10;
  study.tests.loads = {Load::shear};
  return study;
}

TEST(CellTime, GrowsWithTheCellsUnderEveryBoundary) {
  for (const StagePacking& packing : {StagePacking(PackingMethod<2>()), StagePacking(PackingMethod<3>())}) {
    auto study = long_curve();
    study.stages.front().packing = packing;
    for (const auto boundary : {Boundary::periodic, Boundary::displacement, Boundary::traction}) {
      double last = 0.0;
      for (const int cells : {8, 16, 32, 64, 96}) {
        const double seconds = quasistatic_time(study, study.stages.front(), boundary, cells);
        EXPECT_GT(seconds, last) << cells << " cells in " << study.stages.front().dimensions() << " dimensions, "
                                 << name_of(boundary);
        last = seconds;
      }
    }
  }
}

TEST(CellTime, GrowsWithTheLoadsTheContrastAndTheSteps) {
  auto study = long_curve();
  auto& stage = study.stages.front();
  const double one_load = quasistatic_time(study, stage, Boundary::periodic, 48);
  study.tests.loads = {Load::shear, Load::bulk};
  EXPECT_DOUBLE_EQ(quasistatic_time(study, stage, Boundary::periodic, 48), 2.0 * one_load);
  stage.fillers.front().material.shear = PronySeries(584000e6);
  EXPECT_GT(quasistatic_time(study, stage, Boundary::periodic, 48), 4.0 * one_load);
  study.tests.quasistatic.solver = Solver::stepping;
  const double stepping = quasistatic_time(study, stage, Boundary::periodic, 48);
  study.tests.quasistatic.steps_per_decade *= 2;
  EXPECT_DOUBLE_EQ(quasistatic_time(study, stage, Boundary::periodic, 48), 2.0 * stepping);
}

// An elastic binder takes one solution; a binder that relaxes takes more solutions the further it relaxes.
TEST(ExpectedSnapshots, GrowWithTheDecadesOverWhichThePhasesRelax) {
  auto study = long_curve();
  auto& stage = study.stages.front();
  stage.packing = PackingMethod<2>();
  const auto snapshots_with = [&](double equilibrium) {
    auto& matrix = std::get<Material>(stage.matrix);
    matrix.shear = PronySeries(equilibrium, {{1.0, 1e9 - equilibrium}});
    return expected_snapshots(study, stage);
  };
  double last = 0.0;
  for (const double equilibrium : {0.5e9, 1e8, 1e7, 1e6}) {
    EXPECT_GT(snapshots_with(equilibrium), last) << equilibrium;
    last = expected_snapshots(study, stage);
  }
  auto& filler = stage.fillers.front();
  filler.coating = Coating{{"interphase", 1e3, PronySeries(3e9), PronySeries(1e7, {{1e-3, 1e8}})}, 0.01};
  EXPECT_GT(expected_snapshots(study, stage), last) << "a second phase that relaxes";
  filler.coating.reset();
  std::get<Material>(stage.matrix).shear = PronySeries(1e9);
  EXPECT_EQ(expected_snapshots(study, stage), 1.0);
}

}  // namespace
}  // namespace breccia
