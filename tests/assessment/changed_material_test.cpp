#include "assessment/changed_material.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

using Number = MaterialNumber;

const ShiftedMaterial glass = {.material = {"glass", 2500.0, PronySeries(40e9), PronySeries(30e9)}};

const ShiftedMaterial binder = {
    .material = {"binder", 1100.0, PronySeries(3e9), PronySeries(1e6, {{1.0, 2e6}, {1e-3, 5e6}})},
    .shift = TemperatureShift{WilliamsLandelFerry{.c1 = 10.0, .c2 = 100.0, .reference_temperature = 293.15}, 293.15}};

/// A binder of Poisson's ratio 0.35 at all times: K = 3 G.
ShiftedMaterial of_constant_poisson_ratio() {
  auto material = binder;
  material.material.bulk = material.material.shear.scaled(3.0);
  return material;
}

std::string message_of(const ShiftedMaterial& material, const MaterialChange& change) {
  return test::message_of<InputError>([&] { static_cast<void>(changed(material, change)); });
}

TEST(ChangedMaterial, KeepsThePartnerOfAnElasticConstant) {
  const auto of_shear = changed(glass, {.numbers = {{Number::shear, 20e9}}}).material;
  EXPECT_EQ(of_shear.shear.equilibrium(), 20e9);
  EXPECT_EQ(of_shear.bulk.equilibrium(), 40e9);
  // E = 72 GPa and nu = 0.2 of K = 40, G = 30 GPa.
  const auto of_young = changed(glass, {.numbers = {{Number::young, 36e9}}}).material;
  EXPECT_NEAR(of_young.shear.equilibrium() / 15e9, 1.0, 1e-14);
  EXPECT_NEAR(of_young.bulk.equilibrium() / 20e9, 1.0, 1e-14);
  const auto of_poisson = changed(glass, {.numbers = {{Number::poisson, 0.0}}}).material;
  EXPECT_NEAR(of_poisson.shear.equilibrium() / 36e9, 1.0, 1e-14);
  EXPECT_NEAR(of_poisson.bulk.equilibrium() / 24e9, 1.0, 1e-14);
  const auto of_two = changed(glass, {.numbers = {{Number::bulk, 10e9}, {Number::poisson, 0.0}}}).material;
  EXPECT_NEAR(of_two.shear.equilibrium() / 15e9, 1.0, 1e-14);
}

TEST(ChangedMaterial, LeavesTheBulkModulusUnlessPoissonsRatioIsConstant) {
  const MaterialChange change = {.numbers = {{Number::modulus, 2.0}}};
  const auto elastic_in_bulk = changed(binder, change).material;
  EXPECT_EQ(elastic_in_bulk.shear, binder.material.shear.scaled(2.0));
  EXPECT_EQ(elastic_in_bulk.bulk, binder.material.bulk);
  const auto of_constant_ratio = changed(of_constant_poisson_ratio(), change).material;
  EXPECT_NEAR(of_constant_ratio.bulk.at(0.1) / of_constant_ratio.shear.at(0.1), 3.0, 1e-12);
}

TEST(ChangedMaterial, TakesASpectrumWithAnEquilibrium) {
  const MaterialChange change = {.numbers = {{Number::equilibrium, 4e5}},
                                 .shear_terms = std::vector<MaxwellTerm>{{2.0, 3e6}}};
  const auto material = changed(of_constant_poisson_ratio(), change).material;
  EXPECT_EQ(material.shear, PronySeries(4e5, {{2.0, 3e6}}));
  EXPECT_NEAR(material.bulk.at(5.0) / material.shear.at(5.0), 3.0, 1e-12);
}

TEST(ChangedMaterial, MovesAllTimes) {
  const auto material = changed(binder, {.numbers = {{Number::times, 10.0}, {Number::equilibrium, 4e5}}}).material;
  EXPECT_EQ(material.shear, PronySeries(4e5, {{10.0, 2e6}, {1e-2, 5e6}}));
}

TEST(ChangedMaterial, RefusesPairsOfWhichOneChangesTheOther) {
  const std::vector<MaxwellTerm> terms = {{2.0, 3e6}};
  EXPECT_THAT(message_of(binder, {.numbers = {{Number::times, 2.0}}, .shear_terms = terms}),
              HasSubstr("binder.times: cannot be unknown beside the spectrum of the material"));
  EXPECT_THAT(message_of(binder, {.numbers = {{Number::modulus, 2.0}}, .shear_terms = terms}),
              HasSubstr("binder.modulus: cannot be unknown beside the spectrum"));
  EXPECT_THAT(message_of(binder, {.numbers = {{Number::modulus, 2.0}, {Number::equilibrium, 1e5}}}),
              HasSubstr("binder.modulus: cannot be unknown beside the equilibrium"));
  EXPECT_THAT(message_of(glass, {.numbers = {{Number::young, 60e9}, {Number::shear, 30e9}}}),
              HasSubstr("glass.shear: cannot be unknown beside the Young's modulus"));
  EXPECT_THAT(message_of(glass, {.numbers = {}, .shear_terms = terms}),
              HasSubstr("glass.spectrum: the material does not relax"));
}

TEST(ChangedMaterial, ChangesTheShiftLaw) {
  const auto material = changed(binder, {.numbers = {{Number::c1, 8.0}, {Number::c2, 120.0}}});
  const auto& law = std::get<WilliamsLandelFerry>(material.shift->law);
  EXPECT_EQ(law.c1, 8.0);
  EXPECT_EQ(law.c2, 120.0);
  EXPECT_EQ(material.material, binder.material) << "it is at the temperature at which it was";
}

TEST(ChangedMaterial, RefusesWhatHasNoMeaning) {
  EXPECT_THAT(message_of(binder, {.numbers = {{Number::young, 1e9}}}),
              HasSubstr("binder.young: the material relaxes; expected its spectrum, equilibrium, modulus or times"));
  EXPECT_THAT(message_of(glass, {.numbers = {{Number::times, 2.0}}}),
              HasSubstr("glass.times: the material does not relax; expected an elastic constant of it"));
  EXPECT_THAT(message_of(glass, {.numbers = {{Number::c1, 2.0}}}),
              HasSubstr("glass.c1: the material has no shift law"));
  EXPECT_THAT(message_of(glass, {.numbers = {{Number::shear, -1.0}}}),
              HasSubstr("glass.shear: expected a positive modulus, got -1 Pa"));
  EXPECT_THAT(message_of(glass, {.numbers = {{Number::shear, 1e9}, {Number::bulk, 1e9}, {Number::poisson, 0.1}}}),
              HasSubstr("expected at most two elastic constants"));
}

}  // namespace
}  // namespace breccia
