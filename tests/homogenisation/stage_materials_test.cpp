#include "homogenisation/stage_materials.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TestResult sampled(Load load, Boundary boundary, const PronySeries& series, const TimeWindow& window) {
  TestResult test{.id = {.load = load, .boundary = boundary, .grid = TestGrid(12)}};
  for (const double time : logarithmic_times(window, 20)) test.modulus.push_back({time, series.at(time)});
  return test;
}

class StageMaterials : public testing::Test {
 protected:
  StageMaterials() { study.tests.boundaries = {Boundary::displacement}; }

  /// The stage "fine" with a quarter of filler and these moduli under one boundary.
  [[nodiscard]] StageResult fine_with(const PronySeries& shear, const PronySeries& plane_bulk,
                                      Boundary boundary = Boundary::displacement) const {
    const TimeWindow window = {1e-3 * study.tests.first_time, study.tests.last_time};
    StageResult result;
    result.name = "fine";
    result.microstructure.fraction = 0.25;
    result.microstructure.fillers = {{.fraction = 0.25}};
    result.tests = {sampled(Load::shear, boundary, shear, window), sampled(Load::bulk, boundary, plane_bulk, window)};
    return result;
  }

  Study study = test::two_stages();
};

// The densities 1000 and 2000 kg/m^3 mix to 1250.
TEST_F(StageMaterials, FollowTheCurvesOfTheirStage) {
  const PronySeries shear(1e5, {{1e-2, 2e6}}), plane_bulk(3e9, {{1e-2, 1e6}});
  const auto materials = materials_from(study, study.stages[0], {}, fine_with(shear, plane_bulk));
  ASSERT_EQ(materials.size(), 1U);
  EXPECT_EQ(materials[0].boundary, Boundary::displacement);
  EXPECT_EQ(materials[0].method, Method::quasistatic);
  const auto& [material, window, shear_error, bulk_error] = materials[0].result;
  EXPECT_EQ(material.name, "fine");
  EXPECT_DOUBLE_EQ(material.density, 1250.0);
  EXPECT_EQ(window.end, study.tests.last_time);
  EXPECT_LE(shear_error, study.tests.fit_tolerance);
  EXPECT_LE(bulk_error, study.tests.fit_tolerance);
  for (const double time : {1e-3, 1e-2, 5e-2}) {
    EXPECT_NEAR(material.shear.at(time) / shear.at(time), 1.0, study.tests.fit_tolerance) << time;
    const double bulk = material.bulk.at(time) + material.shear.at(time) / 3.0;
    EXPECT_NEAR(bulk / plane_bulk.at(time), 1.0, study.tests.fit_tolerance) << time;
  }
}

TEST_F(StageMaterials, OfABoxWithoutParticlesHaveTheDensityOfTheMatrix) {
  study.stages[0].fillers.clear();
  const auto materials = materials_from(study, study.stages[0], {}, fine_with(PronySeries(1e6), PronySeries(1e9)));
  EXPECT_EQ(materials.at(0).result.material.density, 1000.0);
}

// No series of positive terms rises.
TEST_F(StageMaterials, AreRefusedWhereTheFitIsBad) {
  auto rising = fine_with(PronySeries(1e6), PronySeries(1e9));
  for (auto& sample : rising.tests[0].modulus) sample.modulus *= 1.0 + std::sqrt(sample.time / 50e-3);
  EXPECT_THAT(
      test::message_of<NumericalError>([&] { static_cast<void>(materials_from(study, study.stages[0], {}, rising)); }),
      AllOf(HasSubstr("stage fine, displacement, quasistatic: the fit of G(t), on which later stages build, is up to"),
            HasSubstr("more than tests.fit_tolerance = 3 %")));
  auto rising_bulk = fine_with(PronySeries(1e6), PronySeries(1e9));
  for (auto& sample : rising_bulk.tests[1].modulus) sample.modulus *= 1.0 + std::sqrt(sample.time / 50e-3);
  EXPECT_THAT(test::message_of<NumericalError>(
                  [&] { static_cast<void>(materials_from(study, study.stages[0], {}, rising_bulk)); }),
              HasSubstr("the fit of K(t) + G(t)/3"));
}

TEST_F(StageMaterials, NeedTestsUnderShearAndBulk) {
  auto result = fine_with(PronySeries(1e6), PronySeries(1e9));
  result.tests.pop_back();
  EXPECT_THAT(
      test::message_of<InputError>([&] { static_cast<void>(materials_from(study, study.stages[0], {}, result)); }),
      HasSubstr("no test under bulk with the displacement boundary by the quasistatic method"));
}

TEST_F(StageMaterials, AreTheMatrixOfLaterStagesUnderTheSameBoundaryAndMethod) {
  auto fine = fine_with(PronySeries(1e6), PronySeries(1e9));
  fine.materials = {{Boundary::traction, Method::quasistatic, {test::glass, {}, 0.0, 0.0}},
                    {Boundary::displacement, Method::dynamic, {test::binder, {}, 0.0, 0.0}}};
  const auto matrix = [&](Boundary boundary, Method method) -> const Material& {
    return matrix_of("coarse", study.stages[1].matrix, {fine}, boundary, method);
  };
  std::vector<StageResult> earlier = {fine};
  EXPECT_EQ(matrix_of("coarse", study.stages[1].matrix, earlier, Boundary::traction, Method::quasistatic), test::glass);
  EXPECT_EQ(matrix_of("coarse", study.stages[1].matrix, earlier, Boundary::displacement, Method::dynamic),
            test::binder);
  EXPECT_EQ(matrix_of("fine", study.stages[0].matrix, {}, Boundary::periodic, Method::dynamic), test::binder)
      << "a material is one";
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(matrix(Boundary::traction, Method::dynamic)); }),
              HasSubstr("stage coarse: stage fine has no result for the boundary traction, dynamic"));
  EXPECT_THROW(
      static_cast<void>(matrix_of("coarse", study.stages[1].matrix, {}, Boundary::traction, Method::quasistatic)),
      InputError);
}

}  // namespace
}  // namespace breccia
