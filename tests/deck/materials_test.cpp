#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

class DeckMaterials : public testing::Test {
 protected:
  /// A deck whose only material, with density and bulk modulus, has these lines too.
  [[nodiscard]] static std::string deck(std::string_view lines) {
    return test::join("[materials.binder]\ndensity = \"1 g/cm^3\"\nbulk = \"3 GPa\"\n", lines,
                      "\n[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\ncells = 4\n", test::tests);
  }
  [[nodiscard]] Material material(std::string_view lines) const {
    return directory.study(deck(lines)).materials.at(0).material;
  }
  [[nodiscard]] std::string mistakes(std::string_view lines) const { return directory.mistakes(deck(lines)); }

  test::DeckDirectory directory;
};

TEST_F(DeckMaterials, Elastic) {
  const auto binder = material("shear = \"1 MPa\"");
  EXPECT_EQ(binder, (Material{"binder", 1000.0, PronySeries(3e9), PronySeries(1e6)}));
}

TEST_F(DeckMaterials, PronySeriesFromAFile) {
  directory.write("g.csv", "relaxation_time_s,shear_modulus_Pa\n1e-3,2e6\ninf,5e5\n1,1e6\n");
  EXPECT_EQ(material("shear = { prony = \"g.csv\" }").shear, PronySeries(5e5, {{1.0, 1e6}, {1e-3, 2e6}}));
}

TEST_F(DeckMaterials, EquilibriumBesideAFile) {
  directory.write("g.csv", "relaxation_time_s,modulus_Pa\n1e-3,2e6\n");
  EXPECT_EQ(material("shear = { prony = \"g.csv\" }").shear.equilibrium(), 0.0);
  EXPECT_EQ(material("shear = { prony = \"g.csv\", equilibrium = \"1 MPa\" }").shear.equilibrium(), 1e6);
}

TEST_F(DeckMaterials, PronySeriesInTheDeck) {
  const auto binder =
      material(R"(shear = { equilibrium = "1 MPa", terms = [{ time = "10 ms", modulus = "0.5 MPa" }] })");
  EXPECT_EQ(binder.shear, PronySeries(1e6, {{0.01, 0.5e6}}));
}

// log10 a_T = -6.5 (40 - 19) / (120 + 40 - 19) = -0.96808510638...
TEST_F(DeckMaterials, TemperatureShift) {
  const auto binder = material(R"(shear = { terms = [{ time = "1 s", modulus = "1 MPa" }] }
temperature_shift = { law = "wlf", c1 = 6.5, c2 = "120 K", reference = "19 degC", temperature = "40 degC" })");
  EXPECT_NEAR(std::log10(binder.shear.terms().at(0).relaxation_time), -0.968085106383, 1e-11);
}

// ln a_T = (E_a / R) (1 / T - 1 / T_ref): 120 kJ/mol, 293.15 K, 273.15 K; by hand 3.604840
TEST_F(DeckMaterials, TemperatureShiftByArrhenius) {
  const auto binder = material(R"(shear = { terms = [{ time = "1 s", modulus = "1 MPa" }] }
temperature_shift = { law = "arrhenius", activation_energy = "120 kJ/mol", reference = "20 degC", temperature = "0 degC" })");
  const double expected = 120e3 / 8.31446261815324 * (1.0 / 273.15 - 1.0 / 293.15);
  EXPECT_NEAR(std::log(binder.shear.terms().at(0).relaxation_time), expected, 1e-10);
}

// The temperature is halfway between the rows at 0 and 20 degC, the reference is at 20 degC; the rows may have any
// order.
TEST_F(DeckMaterials, TemperatureShiftByATable) {
  const auto* text = R"(shear = { terms = [{ time = "1 s", modulus = "1 MPa" }] }
temperature_shift = { law = "table", table = "a.csv", reference = "20 degC", temperature = "10 degC" })";
  directory.write("a.csv", "temperature_degC,log10_shift_factor,standard_error\n0,1.5,0.1\n-40,6,0.1\n20,-0.5,0.1\n");
  EXPECT_NEAR(std::log10(material(text).shear.terms().at(0).relaxation_time), 1.0, 1e-12);
  directory.write("a.csv", "temperature_K,shift_factor\n273.15,100\n293.15,1\n");
  EXPECT_NEAR(std::log10(material(text).shear.terms().at(0).relaxation_time), 1.0, 1e-12);
}

TEST_F(DeckMaterials, MistakesInATableOfShiftFactors) {
  const auto* text = R"(shear = "1 MPa"
temperature_shift = { law = "table", table = "a.csv", reference = "20 degC", temperature = "40 degC" })";
  const auto mistakes_of = [&](const std::string& table) {
    directory.write("a.csv", table);
    return mistakes(text);
  };
  EXPECT_THAT(mistakes_of("temperature_degC,log10_shift_factor\n0,1\n30,-1\n"),
              HasSubstr("temperature_shift.temperature: the table of shift factors reaches from 273.15 K (0 degC) to "
                        "303.15 K (30 degC), got 313.15 K (40 degC)"));
  EXPECT_THAT(mistakes_of("temperature_degC,log10_shift_factor\n30,1\n50,-1\n"),
              HasSubstr("temperature_shift.reference: the table of shift factors reaches from 303.15 K"));
  EXPECT_THAT(
      mistakes_of("temperature_degC,log10_shift_factor\n0,1\n30,1\n50,-1\n"),
      HasSubstr("a.csv:3: expected factors that fall as the temperature rises, got log10 a_T = 1 at 30 degC after 1"));
  EXPECT_THAT(mistakes_of("temperature_degC,log10_shift_factor\n0,1\n0,0.5\n50,-1\n"),
              HasSubstr("a.csv:3: expected each temperature once, got 0 degC"));
  EXPECT_THAT(mistakes_of("temperature_degC,log10_shift_factor [-]\n0,900\n-300,800\n50,-1\n"),
              testing::AllOf(HasSubstr("a.csv:2: expected a shift factor between 1e-100 and 1e100, got 10^900"),
                             HasSubstr("a.csv:3: expected a temperature above absolute zero, got -300 degC")));
  EXPECT_THAT(mistakes_of("temperature_degC,shift_factor\n0,1\n30,-1\n"),
              HasSubstr("a.csv:3: expected a positive shift factor, got -1"));
  EXPECT_THAT(mistakes_of("temperature_degC,log10_shift_factor\n20,0\n"),
              HasSubstr("expected at least two temperatures"));
  EXPECT_THAT(mistakes_of("temperature_degC,storage_modulus_Pa\n20,0\n"),
              HasSubstr("no column called shift_factor or log10_shift_factor"));
}

TEST_F(DeckMaterials, AMaterialWithoutStiffnessIsRefused) {
  directory.write("g.csv", "relaxation_time_s,modulus_Pa\n1,0\n");
  const auto* message = "shear.prony: expected a modulus above zero";
  EXPECT_THAT(mistakes("shear = { prony = \"g.csv\" }"), testing::HasSubstr(message));
  directory.write("g.csv", "relaxation_time_s,modulus_Pa\n");
  EXPECT_THAT(mistakes("shear = { prony = \"g.csv\" }"), testing::HasSubstr(message));
  EXPECT_EQ(material("shear = { prony = \"g.csv\", equilibrium = \"1 MPa\" }").shear.at(1.0), 1e6);
}

TEST_F(DeckMaterials, MistakesInAFileHaveItsLine) {
  const auto shear = "shear = { prony = \"g.csv\" }";
  const auto place = "deck.toml:4:19: materials.binder.shear.prony: ";
  directory.write("g.csv", "relaxation_time_s,modulus_Pa\n1e-3,x\n1\n");
  EXPECT_EQ(mistakes(shear), test::join(place, "g.csv:2: modulus_Pa: expected a number, got \"x\"\n", place,
                                        "g.csv:3: expected 2 values (relaxation_time_s, modulus_Pa), got 1"));
  directory.write("g.csv", "relaxation_time_s,modulus_Pa\n1e-3,2\n0,1\n");
  EXPECT_EQ(mistakes(shear), test::join(place, "g.csv:3: expected a positive relaxation time, got 0"));
  directory.write("g.csv", "relaxation_time_s,modulus_Pa\n1e-3,-2\n");
  EXPECT_EQ(mistakes(shear), test::join(place, "g.csv:2: expected a non-negative modulus, got -2"));
  directory.write("g.csv", "relaxation_time_s,modulus_Pa\ninf,2\ninf,3\n");
  EXPECT_EQ(mistakes(shear), test::join(place, "g.csv:3: a second term with an infinite relaxation time"));
  directory.write("g.csv", "time,modulus_Pa\n1,2\n");
  EXPECT_EQ(mistakes(shear),
            test::join(place,
                       "g.csv: no column of relaxation times, such as relaxation_time_s; it has \"time\", "
                       "\"modulus_Pa\""));
  directory.write("g.csv", "relaxation_time_s,G\n1,2\n");
  EXPECT_THAT(mistakes(shear), HasSubstr("g.csv: the unit of \"G\": expected one in the name of the column"));
  directory.write("g.csv", "relaxation_time_s,storage_modulus_Pa\n1,2\n");
  EXPECT_THAT(mistakes(shear), HasSubstr("g.csv: no column of moduli"));
}

TEST_F(DeckMaterials, AnotherModulusIsNotTakenForShear) {
  const auto* shear = "shear = { prony = \"g.csv\" }";
  directory.write("g.csv", "relaxation_time_s,youngs_modulus_Pa\n1,3e6\ninf,1e6\n");
  EXPECT_EQ(mistakes(shear),
            "deck.toml:4:19: materials.binder.shear.prony: g.csv: expected a column of the shear modulus, got "
            "\"youngs_modulus_Pa\", that of Young's modulus: the key young takes it as it is, or convert it by G = E / "
            "(2 (1 + nu)), nu being Poisson's "
            "ratio, and begin the name of the column with shear_");
  directory.write("g.csv", "relaxation_time_s,bulk_modulus_Pa\n1,3e6\n");
  EXPECT_THAT(mistakes(shear), HasSubstr("expected a column of the shear modulus, got \"bulk_modulus_Pa\""));
  directory.write("g.csv", "relaxation_time_s,shear_modulus_Pa\n1,3e6\n");
  const auto bulk = directory.mistakes(test::replaced(deck("shear = \"1 MPa\""), "\"3 GPa\"", "{ prony = \"g.csv\" }"));
  EXPECT_THAT(bulk, HasSubstr("binder.bulk.prony: g.csv: expected a column of the bulk modulus, got "
                              "\"shear_modulus_Pa\", that of the shear modulus"));
}

TEST_F(DeckMaterials, NamesHaveNoControlCharacters) {
  const auto text = test::replaced(deck(R"(shear = "1 MPa")"), "materials.binder", R"(materials."b\nb")");
  EXPECT_THAT(directory.mistakes(text),
              HasSubstr("deck.toml:1:1: materials.b\\u000ab: expected a name without line breaks"));
}

TEST_F(DeckMaterials, Mistakes) {
  EXPECT_THAT(mistakes("shear = \"0 MPa\""), HasSubstr("binder.shear: expected a positive pressure, got \"0 MPa\""));
  EXPECT_THAT(mistakes("shear = {}"), HasSubstr("binder.shear: expected exactly one of prony, terms"));
  EXPECT_THAT(mistakes("shear = { terms = [{ time = \"1 s\" }] }"), HasSubstr("binder.shear.terms.0.modulus: missing"));
  EXPECT_THAT(mistakes("shear = { prony = \"g.csv\", terms = [] }"), HasSubstr("got prony and terms"));
  EXPECT_THAT(mistakes("shaer = \"1 MPa\""), HasSubstr("unknown key \"shaer\", did you mean \"shear\"?"));
  directory.write("g.csv", "relaxation_time_s,modulus_Pa\ninf,2\n");
  EXPECT_THAT(mistakes("shear = { prony = \"g.csv\", equilibrium = \"1 Pa\" }"),
              HasSubstr("equilibrium modulus already"));
}

TEST_F(DeckMaterials, MistakesInATemperatureShift) {
  const auto shift = [](std::string_view lines) {
    return test::join("shear = \"1 MPa\"\n[materials.binder.temperature_shift]\n", lines);
  };
  EXPECT_THAT(mistakes(shift(R"(law = "wlf"
c1 = 6.5
c2 = "120 K"
reference = "19 degC"
temperature = "-120 degC")")),
              HasSubstr("temperature_shift.temperature: the shift law has no meaning at or below 172.15 K (-101 degC) "
                        "(reference temperature - c2), got 153.15 K (-120 degC)"));
  EXPECT_EQ(mistakes(shift("law = \"vogel\"\nc1 = 6.5\ntemperature = \"20 degC\"")),
            "deck.toml:6:7: materials.binder.temperature_shift.law: expected one of \"wlf\", \"arrhenius\", \"table\", "
            "\"measured\", "
            "got \"vogel\"");
  const auto arrhenius = mistakes(shift("law = \"arrhenius\"\nactivation_energy = \"120 kJ\"\nc1 = 6.5"));
  EXPECT_THAT(arrhenius, HasSubstr("activation_energy: expected a molar energy, got \"120 kJ\""));
  EXPECT_THAT(arrhenius, HasSubstr("unknown key \"c1\""));
}

TEST_F(DeckMaterials, BeyondAllScales) {
  EXPECT_THAT(mistakes("shear = { terms = [{ time = \"1 s\", modulus = \"1e308 Pa\" }, "
                       "{ time = \"2 s\", modulus = \"1e308 Pa\" }] }"),
              HasSubstr("shear.terms: expected a modulus above zero"));
  EXPECT_THAT(mistakes("shear = { terms = [{ time = \"1e-200 s\", modulus = \"1 Pa\" }] }"),
              HasSubstr("shear.terms: expected relaxation times between 1e-100 s and 1e100 s"));
}

}  // namespace
}  // namespace breccia
