#include "homogenisation/run/test_requests.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/homogenisation/stage_discretisation.hpp"

#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

class TestRequests : public testing::Test {
 protected:
  TestRequests() {
    study.tests.loads = {Load::diagonal_shear, Load::shear};
    study.tests.field_times = {2e-3, 50e-3};
    study.tests.points_per_decade = 7;
  }
  [[nodiscard]] static Discretisation<2> grid_of(int cells) {
    return Discretisation<2>(Grid<2>{{cells, cells}, 1e-3}, matrix_phase);
  }
  [[nodiscard]] static StageCells cells_of(int cells) { return {grid_of(cells)}; }

  static constexpr PhaseIndex matrix_phase = 0, filler_phase = 1;

  Study study = test::two_stages();
  const Stage& fine = study.stages[0];
  const Stage& coarse = study.stages[1];
};

TEST_F(TestRequests, OfTheQuasistaticMethodHoldAllLoadsOfTheStage) {
  study.tests.quasistatic.steps_per_decade = 33;
  const auto request = make_quasistatic_test(study, fine, test::binder, cells_of(12), Boundary::traction, 3);
  ASSERT_EQ(request.materials.size(), 2U);
  EXPECT_EQ(request.materials[matrix_phase], test::binder);
  EXPECT_EQ(request.materials[filler_phase], test::glass);
  EXPECT_EQ(request.boundary, Boundary::traction);
  EXPECT_THAT(request.loads, ElementsAre(Load::diagonal_shear, Load::shear, Load::bulk)) << "it serves as a matrix";
  EXPECT_EQ(request.times, (TimeWindow{1e-3, 50e-3}));
  EXPECT_EQ(request.points_per_decade, 7);
  EXPECT_THAT(request.field_times, ElementsAre(2e-3, 50e-3));
  EXPECT_EQ(request.options.steps_per_decade, 33);
  EXPECT_EQ(request.options.linear.threads, 3);
  EXPECT_THAT(make_quasistatic_test(study, coarse, test::binder, cells_of(12), Boundary::traction, 3).loads,
              ElementsAre(Load::diagonal_shear, Load::shear));
}

TEST_F(TestRequests, LetTheMatrixVaryAndAFillerThatRelaxes) {
  const auto varying_names = [&] {
    std::vector<std::string> names;
    for (const auto& [index, name] :
         make_quasistatic_test(study, fine, test::binder, cells_of(12), Boundary::traction, 3).varying) {
      names.push_back(name);
      EXPECT_EQ(index, name == "matrix" ? matrix_phase : filler_phase);
    }
    return names;
  };
  EXPECT_THAT(varying_names(), ElementsAre("matrix"));
  study.stages[0].fillers[0].material.bulk = PronySeries(1e9, {{1e-3, 1e9}});
  EXPECT_THAT(varying_names(), ElementsAre("matrix", "filler"));
}

TEST_F(TestRequests, OfTheDynamicMethodHoldOneLoad) {
  study.tests.dynamic.courant = 0.5;
  const auto request =
      make_dynamic_test(study, fine, test::binder, grid_of(12), Boundary::displacement, Load::diagonal_shear, 3);
  EXPECT_EQ(request.materials[filler_phase], test::glass);
  EXPECT_EQ(request.load, Load::diagonal_shear);
  EXPECT_EQ(request.times, (TimeWindow{1e-3, 50e-3}));
  EXPECT_EQ(request.points_per_decade, 7);
  EXPECT_EQ(request.options.courant, 0.5);
  EXPECT_EQ(request.threads, 3);
}

TEST_F(TestRequests, WantFieldsOfTheFirstLoadOnTheFinestGrid) {
  const auto field_times = [&](int cells, Load load) {
    return make_dynamic_test(study, fine, test::binder, grid_of(cells), Boundary::displacement, load, 0).field_times;
  };
  EXPECT_THAT(field_times(12, Load::diagonal_shear), ElementsAre(2e-3, 50e-3));
  EXPECT_THAT(field_times(12, Load::shear), IsEmpty());
  EXPECT_THAT(field_times(6, Load::diagonal_shear), IsEmpty());
  EXPECT_THAT(make_quasistatic_test(study, fine, test::binder, cells_of(6), Boundary::displacement, 0).field_times,
              IsEmpty());
}

TEST_F(TestRequests, OfABoxWithoutParticlesHaveOneMaterial) {
  study.stages[0].fillers.clear();
  EXPECT_THAT(make_quasistatic_test(study, fine, test::binder, cells_of(12), Boundary::traction, 0).materials,
              ElementsAre(test::binder));
}

TEST_F(TestRequests, ExpectAMaterialToBeItself) {
  EXPECT_EQ(expected_matrix(study, fine), test::binder);
  study.stages[0].fillers.clear();
  EXPECT_EQ(expected_matrix(study, coarse), test::binder) << "nothing is put in";
}

// Hashin's lower bound for rigid discs in an incompressible matrix is (1 + f) / (1 - f) = 1.5; compliances under one
// pressure mix: 0.8 / 1 GPa + 0.2 / 10 GPa.
TEST_F(TestRequests, ExpectAStageToBeAboutItsMixture) {
  study.stages[0].fillers[0].fraction = 0.2;
  const auto matrix = expected_matrix(study, coarse);
  EXPECT_EQ(matrix.name, "fine");
  EXPECT_THAT(matrix.density, DoubleNear(1200.0, 1e-9));
  EXPECT_TRUE(matrix.bulk.is_elastic());
  EXPECT_NEAR(matrix.bulk.equilibrium() * (0.8 / 1e9 + 0.2 / 10e9), 1.0, 1e-12);
  for (const double time : {0.0, 1e-2, 1.0}) {
    EXPECT_NEAR(matrix.shear.at(time) / (1.5 * test::binder.shear.at(time)), 1.0, 1e-12) << time;
  }
}

// A filler that is a tenth stiffer than the matrix cannot stiffen it by more than a tenth. Without a fraction a half is
// assumed, which would give a factor of three.
TEST_F(TestRequests, ExpectNoStageStifferThanItsFiller) {
  const auto shear = [&] { return expected_matrix(study, coarse).shear.unrelaxed() / test::binder.shear.unrelaxed(); };
  EXPECT_NEAR(shear(), 3.0, 1e-12);
  study.stages[0].fillers[0].material.shear = test::binder.shear.scaled(1.1);
  EXPECT_LT(shear(), 1.1) << "and softer by more than rounding, so that the filler counts as stiffer";
  EXPECT_NEAR(shear(), 1.1, 1e-5);
}

}  // namespace
}  // namespace breccia
