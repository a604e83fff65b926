#include "breccia/homogenisation/quasistatic_time.hpp"

#include <vector>

#include <gtest/gtest.h>

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

// Processor times of docs/three-dimensions.md, "Cost", within a factor of 1.5.
TEST(QuasistaticTime, OfCubesAgreesWithMeasuredRuns) {
  const auto study = long_curve();
  const auto& stage = study.stages.front();
  struct Measured {
    Boundary boundary;
    int cells;
    double seconds;
  };
  for (const auto& [boundary, cells, seconds] : std::vector<Measured>{{Boundary::periodic, 24, 2.6},
                                                                      {Boundary::periodic, 48, 15.8},
                                                                      {Boundary::periodic, 96, 102.0},
                                                                      {Boundary::displacement, 24, 4.4},
                                                                      {Boundary::displacement, 96, 198.0},
                                                                      {Boundary::traction, 24, 7.0},
                                                                      {Boundary::traction, 96, 350.0}}) {
    const double expected = quasistatic_time(study, stage, boundary, cells);
    EXPECT_GT(expected, seconds / 1.5) << name_of(boundary) << ", " << cells;
    EXPECT_LT(expected, seconds * 1.5) << name_of(boundary) << ", " << cells;
  }
}

TEST(QuasistaticTime, GrowsWithTheLoadsTheContrastAndTheSteps) {
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

}  // namespace
}  // namespace breccia
