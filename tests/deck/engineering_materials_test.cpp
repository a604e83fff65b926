#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "viscoelasticity/engineering_moduli.hpp"

// Tests of materials given by two of bulk, shear, young and poisson, and by measured data.

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class EngineeringMaterials : public testing::Test {
 protected:
  [[nodiscard]] static std::string deck(std::string_view lines) {
    return test::join("[materials.binder]\ndensity = \"1 g/cm^3\"\n", lines,
                      "\n[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\ncells = 4\n", test::tests);
  }
  [[nodiscard]] Material material(std::string_view lines) const {
    return directory.study(deck(lines)).materials.at(0).material;
  }
  [[nodiscard]] std::string mistakes(std::string_view lines) const { return directory.mistakes(deck(lines)); }

  test::DeckDirectory directory;
};

/// With K = 5 GPa and G = 3 GPa, E = 9 K G / (3 K + G) = 7.5 GPa and nu = 1/4.
TEST_F(EngineeringMaterials, AnyTwoElasticConstants) {
  for (const auto* two : {"bulk = \"5 GPa\"\nshear = \"3 GPa\"", "young = \"7.5 GPa\"\npoisson = 0.25",
                          "shear = \"3 GPa\"\npoisson = 0.25", "bulk = \"5 GPa\"\npoisson = 0.25",
                          "bulk = \"5 GPa\"\nyoung = \"7.5 GPa\"", "shear = \"3 GPa\"\nyoung = \"7.5 GPa\""}) {
    const auto binder = material(two);
    EXPECT_NEAR(binder.bulk.equilibrium() / 5e9, 1.0, 1e-14) << two;
    EXPECT_NEAR(binder.shear.equilibrium() / 3e9, 1.0, 1e-14) << two;
    EXPECT_TRUE(binder.bulk.is_elastic() && binder.shear.is_elastic());
  }
}

TEST_F(EngineeringMaterials, ARelaxingYoungsModulusAndPoissonsRatio) {
  const auto binder = material(R"(young = { equilibrium = "1 MPa", terms = [{ time = "1 s", modulus = "2 MPa" }] }
poisson = 0.25)");
  EXPECT_NEAR(binder.shear.at(0.0) / 1.2e6, 1.0, 1e-14);
  EXPECT_NEAR(binder.bulk.at(0.0) / 2e6, 1.0, 1e-14);
  EXPECT_NEAR(binder.shear.terms().at(0).modulus / 0.8e6, 1.0, 1e-14);
}

/// The Young's modulus that follows from the bulk and the shear modulus of the material is the given one.
TEST_F(EngineeringMaterials, ARelaxingYoungsModulusAndABulkModulus) {
  const PronySeries young(3e6, {{10.0, 2e6}, {1e-2, 4e7}, {1e-5, 9e8}});
  directory.write("E.csv", "relaxation_time_s,youngs_modulus_Pa\ninf,3e6\n10,2e6\n1e-2,4e7\n1e-5,9e8\n");
  const auto binder = material("bulk = \"3 GPa\"\nyoung = { prony = \"E.csv\" }");
  const EngineeringModuli moduli(binder.shear, binder.bulk);
  for (double t = 1e-8; t < 1e4; t *= 5.0) EXPECT_NEAR(moduli.youngs_modulus(t) / young.at(t), 1.0, 1e-9);
  EXPECT_EQ(binder.shear.terms().size(), 3U);
}

TEST_F(EngineeringMaterials, AMeasuredModulusIsFitted) {
  // One Maxwell element beside a spring: G' = 1e6 + 5e6 x^2 / (1 + x^2), G'' = 5e6 x / (1 + x^2), x = omega.
  std::string table = "Angular frequency [rad/s];Storage modulus [kPa];Loss modulus [kPa]\n";
  for (double omega = 1e-3; omega < 2e3; omega *= 1.6) {
    const double x = omega * omega / (1.0 + omega * omega);
    table += fmt::format("{};{};{}\n", omega, 1e3 + 5e3 * x, 5e3 * x / omega);
  }
  directory.write("dma.csv", table);
  const auto binder = material("bulk = \"3 GPa\"\nshear = { measured = \"dma.csv\" }");
  for (const double t : {1e-2, 1.0, 10.0}) {
    EXPECT_NEAR(binder.shear.at(t) / (1e6 + 5e6 * std::exp(-t)), 1.0, 5e-3) << t;
  }
}

TEST_F(EngineeringMaterials, AMeasuredModulusOfNoKindIsTakenForThatOfItsKeyWithAWarning) {
  const auto warnings_with = [&](const std::string& column) {
    directory.write("relaxation.csv", "time_s," + column + "\n0.1,1e6\n1,8e5\n10,5e5\n100,4e5\n");
    const auto study = directory.study(deck("bulk = \"3 GPa\"\nshear = { measured = \"relaxation.csv\" }\n"));
    const auto found = study.provenance.warnings.find(study.stages.front().name);
    return found == study.provenance.warnings.end() ? std::vector<std::string>() : found->second;
  };
  EXPECT_THAT(
      warnings_with("modulus_Pa"),
      ElementsAre("materials.binder.shear.measured: relaxation.csv does not say which modulus it has: it is taken "
                  "for G; names of columns that begin with \"shear_\" say it"));
  EXPECT_THAT(warnings_with("shear_modulus_Pa"), IsEmpty());
}

TEST_F(EngineeringMaterials, AModulusThatRisesIsFittedWithAWarning) {
  directory.write("rising.csv", "time_s,shear_modulus_Pa\n0.1,1e5\n1,2e5\n10,8e5\n100,3e6\n");
  const auto study = directory.study(deck("bulk = \"3 GPa\"\nshear = { measured = \"rising.csv\" }\n"));
  EXPECT_THAT(study.provenance.warnings.at(study.stages.front().name),
              ElementsAre(AllOf(HasSubstr("materials.binder.shear.measured: the fit misses the data of rising.csv by "),
                                HasSubstr("or are not those of a linear viscoelastic solid"))));
}

TEST_F(EngineeringMaterials, ASweepOfTemperaturesNeedsItsReference) {
  const std::string data = BRECCIA_DATA_DIRECTORY "/synthetic_dma.csv";
  const auto with = [&](const std::string& more) {
    return test::join("bulk = \"3.6 GPa\"\nshear = { measured = \"", data, "\"", more, " }");
  };
  EXPECT_THAT(mistakes(with("")), HasSubstr("expected the reference_temperature of one of the sweeps, at -41 degC"));
  EXPECT_THAT(mistakes(with(", reference_temperature = \"20 m\"")), HasSubstr("expected a temperature"));
  EXPECT_THAT(mistakes(with(", equilibrium = \"1 MPa\"")), HasSubstr("the fit of measured data finds it"));
}

// The data were computed with c1 = 6.5 and c2 = 120 K at 19 degC, and have 1 % of noise.
TEST_F(EngineeringMaterials, MeasuredModuliAtSeveralTemperaturesHaveTheirShiftLaw) {
  const std::string data = BRECCIA_DATA_DIRECTORY "/synthetic_dma.csv";
  const auto lines =
      test::join("bulk = \"3.6 GPa\"\nshear = { measured = \"", data, "\", reference_temperature = \"19 degC\" }\n");
  const auto study = directory.study(deck(lines));
  const auto& shift = study.materials.at(0).shift.value();
  const auto& law = std::get<WilliamsLandelFerry>(shift.law);
  EXPECT_NEAR(law.c1 / 6.5, 1.0, 0.01);
  EXPECT_NEAR(law.c2 / 120.0, 1.0, 0.01);
  EXPECT_NEAR(shift.temperature, 292.15, 1e-9);

  const auto warm =
      directory.study(deck(lines + R"(temperature_shift = { law = "measured", temperature = "40 degC" })"));
  EXPECT_EQ(warm.materials.at(0).shift.value().temperature, 313.15);
  const double factor = law.shift_factor(313.15);
  const auto& cold_terms = study.materials.at(0).material.shear.terms();
  const auto& warm_terms = warm.materials.at(0).material.shear.terms();
  EXPECT_NEAR(warm_terms.at(0).relaxation_time / (cold_terms.at(0).relaxation_time * factor), 1.0, 1e-12);
}

TEST_F(EngineeringMaterials, AMeasuredShiftLawNeedsMeasuredModuli) {
  EXPECT_THAT(mistakes("bulk = \"3.6 GPa\"\nshear = \"1 GPa\"\n"
                       "temperature_shift = { law = \"measured\", temperature = \"40 degC\" }"),
              HasSubstr("temperature_shift.law: expected one modulus of this material from measured data"));
}

TEST_F(EngineeringMaterials, RefusesWhatIsNoSolid) {
  const std::vector<std::pair<const char*, const char*>> cases = {
      {"young = \"1 GPa\"", "expected two of bulk, shear, young and poisson, got young"},
      {"poisson = 0.3\nyoung = \"1 GPa\"\nbulk = \"1 GPa\"",
       "materials.binder.poisson: expected two of bulk, shear, young and poisson, got bulk and young and poisson"},
      {"young = \"1 GPa\"\npoisson = 0.5", "poisson: expected a number between -0.9 and 0.5"},
      {"young = \"1 GPa\"\npoisson = \"0.3\"", "poisson: expected a number"},
      {"young = \"1 mm\"\npoisson = 0.3", "young: expected a pressure"},
      {"young = \"10 GPa\"\nbulk = \"1 GPa\"", "below nine times the bulk modulus"},
      {"young = \"3 GPa\"\nshear = \"1 GPa\"", "below three times the shear modulus"},
      {"young = { terms = [{ time = \"1 s\", modulus = \"1 MPa\" }] }\nshear = \"1 GPa\"",
       "do not determine its bulk modulus well"},
      {"young = \"1 GPa\"\nbulk = { terms = [{ time = \"1 s\", modulus = \"1 GPa\" }] }",
       "with Young's modulus the bulk modulus is elastic"},
      {"bulk = \"1 GPa\"", "shear: missing"},
      {"bulk = \"3 GPa\"\nshear = { measured = \"none.csv\" }", "none.csv"},
      {"bulk = \"3 GPa\"\nshear = { measured = \"a.csv\", terms = [] }",
       "expected exactly one of prony, terms, measured, law"},
  };
  for (const auto& [lines, message] : cases) EXPECT_THAT(mistakes(lines), HasSubstr(message)) << lines;
}

// |E*| of the bitumen H0 of Some et al. 2022 at 1 rad/s, from its parameters by another program, in Python.
TEST_F(EngineeringMaterials, ALawIsThatOfTheModulusOfItsKey) {
  const auto bitumen = material(R"(bulk = "2.5 GPa"
young = { law = "2s2p1d", static = "1e-7 MPa", glassy = "1 GPa", delta = 2.2, time = "1.94507827 ms", k = 0.22, h = 0.63, beta = 50 })");
  const EngineeringModuli moduli(bitumen.shear, bitumen.bulk);
  EXPECT_NEAR(std::abs(moduli.complex_youngs_modulus(1.0)) / 14.89e6, 1.0, 2e-3);
}

TEST_F(EngineeringMaterials, CreepLawsAreGivenAsCompliances) {
  const auto paste = material(R"(poisson = 0.2
young = { law = "power-law-creep", instantaneous = "40e-6 /MPa", creep = "20 /TPa", time = "1 day", exponent = 0.3 })");
  EXPECT_NEAR(paste.shear.at(0.0) * 2.4 / 25e9, 1.0, 1e-6);
  const auto logarithmic = material(R"(bulk = "5 GPa"
shear = { law = "logarithmic-creep", instantaneous = "1 /GPa", creep = "0.5 /GPa", time = "1 s" })");
  EXPECT_NEAR(logarithmic.shear.at(0.0) / 1e9, 1.0, 1e-6);
  const auto zener = material(R"(bulk = "5 GPa"
shear = { law = "fractional-zener", unrelaxed = "1 GPa", equilibrium = "1 MPa", time = "1 s", exponent = 0.5 })");
  EXPECT_EQ(zener.shear.equilibrium(), 1e6);
}

// Time-temperature superposition and `factors` move the terms of a law as those of any series.
TEST_F(EngineeringMaterials, LawsAreShiftedAndMultiplied) {
  const std::string law =
      R"(shear = { law = "fractional-zener", unrelaxed = "1 GPa", time = "1 s", exponent = 0.5 }
bulk = "5 GPa"
)";
  const auto at_reference = material(law).shear;
  const auto warm = material(
      law +
      R"(temperature_shift = { law = "wlf", c1 = 10, c2 = "100 K", reference = "20 degC", temperature = "30 degC" })");
  const double factor = std::pow(10.0, -10.0 * 10.0 / 110.0);
  EXPECT_NEAR(warm.shear.at(1.0 * factor) / at_reference.at(1.0), 1.0, 1e-12);
  const auto multiplied = material(law + "factors = { times = 10, modulus = 2 }").shear;
  EXPECT_NEAR(multiplied.at(10.0) / (2.0 * at_reference.at(1.0)), 1.0, 1e-12);
}

TEST_F(EngineeringMaterials, RefusesLawsThatAreWrong) {
  const std::string zener = R"("fractional-zener", unrelaxed = "1 GPa", time = "1 s")";
  const std::string bitumen = R"("2s2p1d", static = "0 Pa", glassy = "1 GPa", delta = 2.2, time = "1 s")";
  const std::string creep = R"("power-law-creep", instantaneous = "1 /GPa", time = "1 s")";
  const std::vector<std::pair<std::string, const char*>> cases = {
      {R"("2S2P1D")", "shear.law: expected one of \"2s2p1d\", \"fractional-zener\", \"power-law-creep\", "},
      {bitumen + ", k = 0.22, h = 1.2", "shear.h: expected a number between 0 and 1"},
      {bitumen + ", k = 0.7, h = 0.6", "shear.law: k: expected a number above 0 and up to h, 0.6, got 0.7"},
      {bitumen + ", k = 0.2", "shear.h: missing"},
      {bitumen + ", k = 0.2, h = 0.6, gamma = 2", "shear: unknown key \"gamma\""},
      {zener, "shear.exponent: missing"},
      {zener + R"(, exponent = 0.5, equilibrium = "2 GPa")", "shear.law: unrelaxed: expected more than equilibrium"},
      {zener + ", exponent = 0.99", "shear.law: no series of 24 terms a decade follows this law"},
      {creep + R"(, creep = "1 GPa", exponent = 0.5)", "shear.creep: expected a compliance"},
      {creep + R"(, creep = "-1 /GPa", exponent = 0.5)", "shear.creep: expected a positive compliance"},
      {creep + R"(, creep = "1 /GPa", exponent = 0.5, terms = [])",
       "expected exactly one of prony, terms, measured, law"},
      {zener + R"(, exponent = 0.5, equilibrium = "1 MPa", prony = "g.csv")", "expected exactly one of"},
  };
  for (const auto& [law, message] : cases) {
    EXPECT_THAT(mistakes("bulk = \"3 GPa\"\nshear = { law = " + law + " }"), HasSubstr(message)) << law;
  }
}

TEST_F(EngineeringMaterials, AMeasuredModulusOfAnotherKindIsRefused) {
  directory.write("E.csv", "time_s,youngs_modulus_Pa\n1,3\n2,2\n3,1\n");
  EXPECT_THAT(mistakes("bulk = \"3 GPa\"\nshear = { measured = \"E.csv\" }"),
              HasSubstr("expected a column of the shear modulus"));
  EXPECT_NO_THROW(static_cast<void>(material("bulk = \"3 GPa\"\nyoung = { measured = \"E.csv\" }")));
}

}  // namespace
}  // namespace breccia
