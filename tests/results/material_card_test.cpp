// Tests of cards of finite element programs: they are read back by the rules of each program and compared in G(t) and
// K(t).

#include "results/material_card.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "card_parsers.hpp"
#include "messages.hpp"

namespace breccia::test {
namespace {

using ::testing::HasSubstr;

/// A composite that relaxes in shear from 2.4 GPa to 12 MPa over ten decades, and in bulk a little.
Composite composite_of_cards() {
  std::vector<MaxwellTerm> shear, bulk;
  for (int k = -9; k < 3; ++k) {
    shear.push_back({2.0 * std::pow(10.0, k), 2e8 * std::exp(-0.1 * (k + 3) * (k + 3)) + 1e6});
    bulk.push_back({2.0 * std::pow(10.0, k), 5e7});
  }
  Composite composite;
  composite.title = "Composite";
  composite.stage = "HB-1";
  composite.dimensions = 3;
  composite.density = 1800.0;
  composite.shear = PronySeries(1.2e7, shear);
  composite.dilatational = PronySeries(8e9, bulk);
  composite.shift = TemperatureShift{WilliamsLandelFerry{6.5, 120.0, 292.15}, 310.0};
  composite.times = {1e-8, 1e-1};
  return composite;
}

double deviation_of(const PronySeries& read, const PronySeries& expected, const TimeWindow& times) {
  double largest = 0.0;
  constexpr double step = 1.013;
  for (double t = times.begin; t <= times.end; t *= step) {
    largest = std::max(largest, std::abs(read.at(t) / expected.at(t) - 1.0));
  }
  return largest;
}

class Card : public ::testing::TestWithParam<Word<CardFormat>> {};

TEST_P(Card, IsReadBackWithinTheTolerance) {
  const auto& [name, format] = GetParam();
  const auto composite = composite_of_cards();
  // The share of a bulk modulus that a branch of MOOSE needs, and the digits that a field of LS-DYNA holds.
  constexpr double of_format = 2e-5;
  for (const double tolerance : {0.05, 0.01}) {
    const CardSettings settings{.format = format, .tolerance = tolerance};
    const auto card = material_card(composite, settings);
    const auto read = parse_card(std::string(name), text_of(card, settings));
    const double of_shear = deviation_of(read.shear, composite.shear, composite.times);
    const double of_bulk = deviation_of(read.bulk, *composite.dilatational, composite.times);
    RecordProperty("deviation of G(t)", std::to_string(of_shear));
    RecordProperty("deviation of K(t)", std::to_string(of_bulk));
    EXPECT_LT(of_shear, tolerance + of_format) << name;
    EXPECT_LT(of_bulk, tolerance + of_format) << name;
    EXPECT_NEAR(of_shear, card.shear_deviation, 0.1 * card.shear_deviation + of_format);
    EXPECT_NEAR(read.density, 1800.0, 1e-9);
    if (format != CardFormat::ansys) {
      EXPECT_EQ(read.name, "HB_1");
    }
  }
}

TEST_P(Card, HasTheShiftOfTheBinderOrSaysThatItHasNot) {
  const auto& [name, format] = GetParam();
  const CardSettings settings{.format = format};
  const auto composite = composite_of_cards();
  const auto text = text_of(material_card(composite, settings), settings);
  const auto read = parse_card(std::string(name), text);
  if (format == CardFormat::ls_dyna || format == CardFormat::openradioss || format == CardFormat::moose) {
    EXPECT_FALSE(read.shift);
    EXPECT_THAT(text, HasSubstr("The shift is not part of the card"));
    return;
  }
  ASSERT_TRUE(read.shift);
  EXPECT_EQ(read.shift->reference_temperature, 310.0);
  const auto& law = std::get<WilliamsLandelFerry>(composite.shift->law);
  for (const double temperature : {260.0, 292.15, 330.0}) {
    EXPECT_NEAR(std::log10(read.shift->shift_factor(temperature)),
                std::log10(law.shift_factor(temperature) / law.shift_factor(310.0)), 1e-10);  // of twelve digits
  }
}

TEST_P(Card, ListsAShiftThatIsATable) {
  const auto& [name, format] = GetParam();
  const CardSettings settings{.format = format};
  auto composite = composite_of_cards();
  composite.shift = TemperatureShift{ShiftTable({290.0, 330.0}, {1.0, -1.0}, 310.0), 300.0};
  const auto text = text_of(material_card(composite, settings), settings);
  EXPECT_FALSE(parse_card(std::string(name), text).shift);
  EXPECT_THAT(text, HasSubstr("At 300 K; the shift is not part of the card, because it is a table"));
  EXPECT_THAT(text, HasSubstr("  290, 0.5\n"));
  EXPECT_THAT(text, HasSubstr("  330, -1.5\n"));
}

TEST_P(Card, IsWrittenInMillimetresAndTonnes) {
  const auto& [name, format] = GetParam();
  const CardSettings settings{.format = format, .units = CardUnits::mm_t_s};
  const auto composite = composite_of_cards();
  const auto read = parse_card(std::string(name), text_of(material_card(composite, settings), settings));
  EXPECT_NEAR(read.density / 1.8e-9, 1.0, 1e-9);
  EXPECT_NEAR(read.shear.at(1e-4) / (composite.shear.at(1e-4) / 1e6), 1.0, 0.01);
}

TEST_P(Card, OfAnElasticCompositeHasNoTerms) {
  const auto& [name, format] = GetParam();
  auto composite = composite_of_cards();
  composite.shear = PronySeries(3e9);
  composite.dilatational = PronySeries(9e9);
  const CardSettings settings{.format = format};
  const auto read = parse_card(std::string(name), text_of(material_card(composite, settings), settings));
  EXPECT_NEAR(read.shear.at(0.0) / 3e9, 1.0, 1e-9);
  EXPECT_NEAR(read.bulk.at(0.0) / 9e9, 1.0, 1e-9);
  EXPECT_TRUE(read.shear.is_elastic());
}

INSTANTIATE_TEST_SUITE_P(Formats, Card, ::testing::ValuesIn(words<CardFormat>), [](const auto& format) {
  std::string name(format.param.first);
  std::erase(name, '-');
  return name;
});

TEST(MaterialCard, TakesAGivenBulkModulusOrPoissonsRatio) {
  auto composite = composite_of_cards();
  composite.dilatational.reset();
  const auto elastic = material_card(composite, {.bulk = 7e9});
  EXPECT_EQ(elastic.bulk, PronySeries(7e9));
  EXPECT_FALSE(elastic.bulk_deviation);
  const auto constant = material_card(composite, {.poisson = 0.25});
  for (const double t : {1e-8, 1e-4, 1e-1}) {
    EXPECT_NEAR(constant.bulk.at(t) / constant.shear.at(t), 5.0 / 3.0, 1e-6);  // K / G at nu = 1/4
  }
}

TEST(MaterialCard, TakesTheBulkModulusOfPlaneStrainFromTwoTests) {
  auto composite = composite_of_cards();
  composite.dimensions = 2;
  const auto bulk = *composite.dilatational;
  composite.dilatational = PronySeries::sum(bulk, composite.shear.scaled(1.0 / 3.0));
  const auto card = material_card(composite, {});
  EXPECT_LT(deviation_of(card.bulk, bulk, composite.times), 0.01);
  EXPECT_THAT(card.origin, ::testing::Contains(HasSubstr("plane strain")));
}

TEST(MaterialCard, RefusesWhatItDoesNotKnow) {
  auto composite = composite_of_cards();
  composite.dilatational.reset();
  EXPECT_THAT(message_of<InputError>([&] { static_cast<void>(material_card(composite, {})); }),
              HasSubstr("was not tested in bulk"));
  const auto mistakes = message_of<InputError>([&] {
    static_cast<void>(material_card(composite, {.tolerance = 0.0, .times = TimeWindow{2.0, 1.0}, .poisson = 0.5}));
  });
  for (const auto* mistake : {"tolerance: ", "times: ", "Poisson's ratio: "}) EXPECT_THAT(mistakes, HasSubstr(mistake));
}

TEST(MaterialCard, RefusesTimesWithoutResults) {
  const auto composite = composite_of_cards();
  for (const auto& times : {TimeWindow{1e-9, 1e-2}, TimeWindow{1e-7, 1.0}}) {
    EXPECT_THAT(message_of<InputError>([&] { static_cast<void>(material_card(composite, {.times = times})); }),
                HasSubstr("expected times of the results, from 1e-08 to 0.1 s"));
  }
}

TEST_P(Card, OfAModulusThatRelaxesToNothingKeepsALittle) {
  const auto& [name, format] = GetParam();
  auto composite = composite_of_cards();
  composite.shear = PronySeries(0.0, composite.shear.terms());
  composite.dilatational = PronySeries(0.0, composite.dilatational->terms());
  const CardSettings settings{.format = format};
  const auto read = parse_card(std::string(name), text_of(material_card(composite, settings), settings));
  EXPECT_GT(read.shear.equilibrium(), 0.0);
  EXPECT_GT(read.bulk.equilibrium(), 0.0);
  EXPECT_LT(deviation_of(read.shear, composite.shear, composite.times), 0.0102);
}

/// The spectrum of twelve decades has more terms than LS-DYNA takes.
TEST(MaterialCard, RefusesMoreTermsThanTheProgramTakes) {
  auto composite = composite_of_cards();
  std::vector<MaxwellTerm> dense;
  for (int k = -36; k < 12; ++k) dense.push_back({std::pow(10.0, k / 4.0), 5e7});
  composite.shear = PronySeries(1.2e7, dense);
  const auto message = message_of<InputError>(
      [&] { static_cast<void>(material_card(composite, {.format = CardFormat::ls_dyna, .tolerance = 1e-8})); });
  EXPECT_THAT(message, HasSubstr("LS-DYNA takes at most 17 terms"));
}

/// The measured binder has 22 decades, of which the times of the card cover nine.
TEST(MaterialCard, OfABinderFitsLsDyna) {
  auto composite = composite_of_cards();
  std::vector<MaxwellTerm> terms;
  constexpr std::array moduli = {4168.7,   7413.1,   15849.0,  38019.0,  67608.0,  89125.0,  1.1561e5, 1.4223e5,
                                 1.6218e5, 2.2182e5, 4.7534e5, 2.6182e6, 1.2882e7, 5.2481e7, 2.2387e8, 4.3652e8,
                                 4.5709e8, 3.4674e8, 2.5119e8, 1.7783e8, 1.1749e8, 7.5858e7};
  for (std::size_t i = 0; i < moduli.size(); ++i) {
    terms.push_back({1.5 * std::pow(10.0, 7.0 - static_cast<double>(i)), moduli.at(i)});
  }
  composite.shear = PronySeries(0.0, terms);
  composite.dilatational = PronySeries(3.6e9);
  composite.times = {1e-8, 10.0};
  const CardSettings settings{.format = CardFormat::ls_dyna, .tolerance = 0.01};
  const auto card = material_card(composite, settings);
  EXPECT_LE(card.shear.terms().size(), 13U);  // the terms from 1.5e-10 to 150 s
  const auto read = parse_card("ls-dyna", text_of(card, settings));
  EXPECT_LT(deviation_of(read.shear, composite.shear, composite.times), 0.0101);
}

TEST(MaterialCard, IsNotRefusedWhereTheResultHasSoFewTerms) {
  const auto composite = composite_of_cards();  // of twelve terms
  const auto card = material_card(composite, {.format = CardFormat::ls_dyna, .tolerance = 1e-12});
  EXPECT_LE(card.shear.terms().size(), 12U);
  EXPECT_LE(card.shear_deviation, 1e-12);
}

TEST(MaterialCard, RefusesARatioThatOpenRadiossTakesForAnother) {
  const auto composite = composite_of_cards();
  for (const double ratio : {0.0, -0.2}) {
    const auto message = message_of<InputError>(
        [&] { static_cast<void>(material_card(composite, {.format = CardFormat::openradioss, .poisson = ratio})); });
    EXPECT_THAT(message, HasSubstr("OpenRadioss takes Poisson's ratios between 0 and 0.5; that at infinite time is "));
  }
}

/// Where the binder has relaxed, the ratio is near 0.5, and the bulk modulus hangs on its last digits.
TEST(MaterialCard, OfASoftCompositeKeepsItsBulkModulusInOpenRadioss) {
  auto composite = composite_of_cards();
  composite.shear = PronySeries(2e4, {{1e-3, 1e9}});
  composite.dilatational = PronySeries(9e9);
  const CardSettings settings{.format = CardFormat::openradioss, .tolerance = 0.001};
  const auto read = parse_card("openradioss", text_of(material_card(composite, settings), settings));
  EXPECT_NEAR(read.bulk.equilibrium() / 9e9, 1.0, 1e-8);
}

// A term that has relaxed before the first time is more of the modulus at t = 0 than all that was computed.
TEST(MaterialCard, WarnsOfAModulusAtTheBeginningThatIsFarAboveThatOfItsFirstTime) {
  auto composite = composite_of_cards();
  EXPECT_THAT(material_card(composite, {}).warnings, ::testing::IsEmpty());
  composite.shear = PronySeries(1e6, {{0.4e-8, 63e6}, {1e-5, 3e6}});
  const auto card = material_card(composite, {});
  ASSERT_EQ(card.warnings.size(), 1U);
  EXPECT_THAT(card.warnings.front(), HasSubstr("HB_1: at t = 0 the card has G = "));
  EXPECT_THAT(card.warnings.front(), HasSubstr("times that at its first time, 10 ns"));
  EXPECT_THAT(text_of(card, {}), HasSubstr("Warning: HB_1: at t = 0"));
}

TEST(MaterialCard, WarnsOfANegativePoissonsRatio) {
  const auto composite = composite_of_cards();
  const auto wrong_unit = material_card(composite, {.bulk = 1e6});
  ASSERT_EQ(wrong_unit.warnings.size(), 2U);
  const double shear = wrong_unit.shear.unrelaxed();
  const double ratio = (3e6 - 2.0 * shear) / (6e6 + 2.0 * shear);
  EXPECT_LT(ratio, -0.9);
  EXPECT_THAT(wrong_unit.warnings[0], HasSubstr(fmt::format("Poisson's ratio of the card is {:.3g} at t = 0", ratio)));
  EXPECT_THAT(wrong_unit.warnings[0], HasSubstr("(K = 1 MPa, G = "));
  EXPECT_THAT(wrong_unit.warnings[0], HasSubstr("expected one from 0 to below 0.5"));
  EXPECT_THAT(text_of(wrong_unit, {}), HasSubstr("Warning: HB_1: Poisson's ratio"));
  EXPECT_EQ(material_card(composite, {.poisson = -0.2}).warnings.size(), 2U);
  EXPECT_TRUE(material_card(composite, {.bulk = 7e9}).warnings.empty());
  EXPECT_TRUE(material_card(composite, {}).warnings.empty());
}

TEST(MaterialCard, RefusesABulkModulusThatRises) {
  auto composite = composite_of_cards();
  composite.dimensions = 2;
  composite.dilatational = PronySeries(8e9);  // so K(t) = 8 GPa - G(t)/3, which rises by 3 %
  EXPECT_THAT(message_of<InputError>([&] { static_cast<void>(material_card(composite, {})); }),
              HasSubstr("only relaxes"));
  EXPECT_NO_THROW(static_cast<void>(material_card(composite, {.tolerance = 0.05})));
}

}  // namespace
}  // namespace breccia::test
