// Tests of the dynamic against the quasi-static method, which solve the same discretisation in two ways.

#include <cstddef>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "virtual_test/composites.hpp"
#include "virtual_test/dynamic_test.hpp"
#include "virtual_test/quasistatic_test.hpp"

namespace breccia {
namespace {

namespace composites = testing_composites;

class Methods : public testing::TestWithParam<std::tuple<Boundary, Load>> {
 protected:
  static void expect_agreement(DynamicTest<2> test) {
    std::tie(test.boundary, test.load) = GetParam();
    const QuasistaticTest still = {.composite = test.discretisation,
                                   .materials = test.materials,
                                   .varying = {{composites::matrix, "matrix"}},
                                   .volumetric = test.volumetric,
                                   .boundary = test.boundary,
                                   .loads = {test.load},
                                   .times = test.times};
    const auto dynamic = run_dynamic_test(test);
    const auto quasistatic = run_quasistatic_test(still).responses.front();
    for (const auto& overlap : dynamic.overlaps) EXPECT_LT(overlap.mismatch, 0.01);
    if (test.boundary == Boundary::traction) {
      ASSERT_EQ(dynamic.compliance.size(), quasistatic.compliance.size());
      for (std::size_t i = 0; i < dynamic.compliance.size(); ++i) {
        EXPECT_NEAR(dynamic.compliance[i].compliance / quasistatic.compliance[i].compliance, 1.0, 0.005)
            << "at " << dynamic.compliance[i].time;
      }
    } else {
      ASSERT_EQ(dynamic.curve.size(), quasistatic.modulus.size());
      for (std::size_t i = 0; i < dynamic.curve.size(); ++i) {
        EXPECT_NEAR(dynamic.curve[i].modulus / quasistatic.modulus[i].modulus, 1.0, 0.005)
            << "at " << dynamic.curve[i].time;
      }
      EXPECT_TRUE(dynamic.compliance.empty());
    }
  }
};

TEST_P(Methods, AgreeOnTheModelComposite) {
  DynamicTest<2> test = {.discretisation = composites::model_composite(24),
                         .materials = {composites::binder, composites::particle},
                         .times = {1e-3, 0.05}};
  test.volumetric = Volumetric::standard;
  expect_agreement(test);
}

TEST_P(Methods, AgreeOnAPackingOfDiscs) {
  expect_agreement({.discretisation = composites::packed_discs(30),
                    .materials = {composites::elastomer, composites::crystal},
                    .times = {1e-6, 1e-4}});
}

INSTANTIATE_TEST_SUITE_P(All, Methods,
                         testing::Combine(testing::Values(Boundary::displacement, Boundary::traction,
                                                          Boundary::periodic),
                                          testing::Values(Load::shear, Load::diagonal_shear, Load::bulk)),
                         [](const auto& chosen) {
                           const auto boundary = std::get<Boundary>(chosen.param);
                           const auto load = std::get<Load>(chosen.param);
                           return std::string(boundary == Boundary::displacement ? "Displacement"
                                              : boundary == Boundary::traction   ? "Traction"
                                                                                 : "Periodic") +
                                  (load == Load::shear  ? "Shear"
                                   : load == Load::bulk ? "Bulk"
                                                        : "DiagonalShear");
                         });

}  // namespace
}  // namespace breccia
