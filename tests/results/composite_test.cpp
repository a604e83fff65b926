#include "results/composite.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "hand_made_results.hpp"
#include "messages.hpp"

namespace breccia {
namespace {

using ::testing::HasSubstr;

const TemperatureShift shift = {WilliamsLandelFerry{10.0, 100.0, 300.0}, 320.0};

/// Two stages: the coarse one has 40 % of filler and 10 % of coating in all, the rest is the binder.
StudyContent chain() {
  StudyContent content;
  content.title = "chain";
  content.times = {1e-3, 1.0};
  content.stages = {{"fine", "binder", 2, {{"filler", 0.2, 0.3}}},
                    {"coarse", "fine", 2, {{"filler", 0.4, 0.5}, {"coating", 0.1, 0.1}}}};
  content.materials = {{{"binder", 1000.0, PronySeries(2e9), PronySeries(1e6, {{1.0, 1e6}})}, shift},
                       {{"filler", 2000.0, PronySeries(9e9), PronySeries(5e9)}},
                       {{"coating", 1500.0, PronySeries(3e9), PronySeries(1e9)}}};
  return content;
}

StageSeries series(const std::string& stage, Load load, Boundary boundary, double modulus) {
  return {stage, load, boundary, PronySeries(modulus)};
}

std::vector<StageSeries> periodic_series() {
  return {series("fine", Load::shear, Boundary::periodic, 1e6), series("coarse", Load::shear, Boundary::periodic, 3e6),
          series("coarse", Load::bulk, Boundary::periodic, 5e9)};
}

TEST(Composite, IsTheLastStageWithAllThatIsInItsMatrix) {
  const auto composite = composite_of(chain(), periodic_series(), {}, "here");
  EXPECT_EQ(composite.stage, "coarse");
  EXPECT_EQ(composite.boundary, Boundary::periodic);
  EXPECT_EQ(composite.shear, PronySeries(3e6));
  EXPECT_DOUBLE_EQ(composite.density, 0.4 * 2000.0 + 0.1 * 1500.0 + 0.5 * 1000.0);
  ASSERT_TRUE(composite.bulk());
  EXPECT_DOUBLE_EQ(composite.bulk()->equilibrium(), 5e9 - 3e6 / 3.0) << "plane strain measures K + G/3";
  ASSERT_TRUE(composite.shift) << "the binder alone relaxes, at the end of a chain of two";
  EXPECT_EQ(composite.shift->temperature, 320.0);
}

TEST(Composite, HasNoShiftWhereAnythingButTheBinderRelaxes) {
  auto content = chain();
  content.materials[2].material.shear = PronySeries(1e8, {{1.0, 1e9}});
  EXPECT_FALSE(composite_of(content, periodic_series(), {}, "here").shift);
  EXPECT_TRUE(composite_of(content, periodic_series(), {.stage = "fine"}, "here").shift);
}

TEST(Composite, AChoiceThatIsLeftOpenIsRefused) {
  auto both = periodic_series();
  both.push_back(series("coarse", Load::shear, Boundary::traction, 1e6));
  const auto refusal = [&](const CompositeChoice& choice) {
    return test::message_of<InputError>([&] { static_cast<void>(composite_of(chain(), both, choice, "here")); });
  };
  EXPECT_THAT(refusal({}), HasSubstr("here: stage coarse has results of several boundary conditions; choose one"));
  EXPECT_THAT(refusal({.stage = "coarsse"}),
              HasSubstr("here: no results of a stage \"coarsse\", did you mean \"coarse\"?"));
  EXPECT_THAT(refusal({.boundary = Boundary::displacement}), HasSubstr("was not tested under the boundary condition"));
  EXPECT_THAT(refusal({.boundary = Boundary::periodic, .shear_load = Load::bulk}),
              HasSubstr("expected a load of shear"));
}

TEST(Composite, SeriesOfAStageAreThoseOfItsPreferredTests) {
  auto coarse = test::test_with({Load::shear, Boundary::traction, Method::quasistatic, TestGrid(8)}, {{1.0, 2.0}});
  auto fine = test::test_with({Load::shear, Boundary::traction, Method::quasistatic, TestGrid(16)}, {{1.0, 1.0}});
  coarse.series = PronySeries(2.0);
  fine.series = PronySeries(1.0);
  const auto all = series_of(test::stage_with("box", {coarse, fine}));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.front().series, PronySeries(1.0));
}

}  // namespace
}  // namespace breccia
