// Tests of the notations of `sizes`.

#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/microstructure/draw_diameters.hpp"

#include "deck_stages.hpp"
#include "study/filler_sizes.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Decks of one stage, a box of 6 mm with a random packing.
class DeckSizes : public test::DeckStages {
 protected:
  [[nodiscard]] static std::string keys(std::string_view sizes) { return test::join("fraction = 0.5, ", sizes); }
  [[nodiscard]] static std::string lines(std::string_view sizes) {
    return test::join("cells = 60\nfiller = { material = \"hmx\", ", keys(sizes),
                      " }\npacking = { method = \"lubachevsky-stillinger\" }\n");
  }
  /// The study with these sizes, as its results depend on it.
  [[nodiscard]] std::string content(std::string_view sizes) const {
    return directory.study(deck(lines(sizes))).provenance.content;
  }
  [[nodiscard]] Filler filler_with(std::string_view sizes) const { return stage(lines(sizes)).fillers.at(0); }
  [[nodiscard]] SizeDistribution distribution(std::string_view sizes) const {
    return distribution_of(filler_with(sizes)).value();
  }
  [[nodiscard]] std::vector<double> drawn(std::string_view sizes) const {
    return draw_diameters<2>(distribution(sizes), 0.5, 6e-3);
  }
  [[nodiscard]] std::string mistakes_of(std::string_view sizes) const {
    return mistakes(keys(sizes), test::random_packing);
  }
};

/// Rows of a sieve analysis at sizes [m] from the first to the last, in equal ratios.
std::string rows_of(const std::function<double(double)>& share, double first, double last, int count) {
  std::string rows;
  for (int row = 0; row < count; ++row) {
    const double size = first * std::pow(last / first, static_cast<double>(row) / (count - 1));
    const double passing = (share(size) - share(first)) / (share(last) - share(first));
    rows += fmt::format("{}{{ size = \"{:.17g} m\", passing = {:.17g} }}", row == 0 ? "" : ", ", size, passing);
  }
  return rows;
}

void expect_near(const std::vector<double>& drawn, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(drawn.size(), expected.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) ASSERT_NEAR(drawn[i] / expected[i], 1.0, tolerance) << i;
}

TEST_F(DeckSizes, NotationsOfOneCurveGiveTheSameBoxes) {
  directory.write("rising.csv", "size [mm],passing [%]\n0.2,0\n2,100\n");
  directory.write("shuffled.csv", "size [mm],passing [%]\n2,100\n0.2,0\n");
  const auto even = R"(sizes = { from = "0.2 mm", to = "2 mm" })";
  for (const auto* same : {
           R"(sizes = { passing = [{ size = "0.2 mm", passing = 0 }, { size = "2 mm", passing = 1 }] })",
           R"(sizes = { passing = [{ size = "2 mm", passing = "100 %" }, { size = "200 um", passing = "0 %" }] })",
           R"(sizes = "rising.csv")",
           R"(sizes = "shuffled.csv")",
           R"(sizes = { from = "0.2 mm", to = "2 mm" }, from = "0.2 mm", to = "2 mm")",
       }) {
    EXPECT_EQ(content(same), content(even)) << same;
  }
  const auto expected = drawn(even);
  ASSERT_GT(expected.size(), 50U);
  // The middle row is where F is one half, but for rounding.
  directory.write("three.csv", "size [mm],passing [%]\n2,100\n0.2,0\n0.632455532033676,50\n");
  expect_near(drawn(R"(sizes = "three.csv")"), expected, 1e-12);
}

TEST_F(DeckSizes, ASieveAnalysisIsReadInAnyOrder) {
  const auto sizes = filler_with(R"(sizes = { passing = [
  { size = "2 mm",     passing = "40 %" },
  { size = "4 mm",     passing = 1.0 },
  { size = "0.063 mm", passing = "0 %" },
] })")
                         .sizes.value();
  const auto& table = std::get<TabulatedSizes>(sizes);
  EXPECT_THAT(table.diameters, ElementsAre(DoubleEq(6.3e-5), DoubleEq(2e-3), DoubleEq(4e-3)));
  EXPECT_THAT(table.cumulative_volume_fractions, ElementsAre(0.0, 0.4, 1.0));
  EXPECT_TRUE(table.file.empty());
}

TEST_F(DeckSizes, ARowOfASieveAnalysisCanBeSet) {
  const auto text =
      deck(lines(R"(sizes = { passing = [{ size = "1 mm", passing = 0 }, { size = "2 mm", passing = "40 %" },
  { size = "4 mm", passing = 1 }] })"));
  const auto study = directory.study(text, {"stages.a.filler.sizes.passing.1.passing=55 %"});
  const auto& table = std::get<TabulatedSizes>(study.stages.at(0).fillers.at(0).sizes.value());
  EXPECT_THAT(table.cumulative_volume_fractions, ElementsAre(0.0, 0.55, 1.0));
}

TEST_F(DeckSizes, LawsAreThoseOfFineTables) {
  const auto fuller = [](double size) { return std::pow(size / 2e-3, 0.45); };
  const auto ground = [](double size) { return -std::expm1(-std::pow(size / 0.8e-3, 1.2)); };
  const auto table_of = [](const std::function<double(double)>& share, double first) {
    return fmt::format("sizes = {{ passing = [{}] }}", rows_of(share, first, 2e-3, 200));
  };
  // Between rows F is off by an eighth of its second derivative times the square of their distance.
  expect_near(drawn(table_of(fuller, 0.1e-3)),
              drawn(R"(sizes = { fuller = "2 mm", exponent = 0.45 }, from = "0.1 mm")"), 1e-4);
  expect_near(drawn(table_of(ground, 0.2e-3)),
              drawn(R"(sizes = { rosin_rammler = "0.8 mm", exponent = 1.2 }, from = "0.2 mm", to = "2 mm")"), 5e-4);
}

TEST_F(DeckSizes, FullersCurveHasADefaultExponentAndEnd) {
  const auto curve = filler_with(R"(sizes = { fuller = "2 mm" }, from = "0.1 mm")");
  EXPECT_EQ(std::get<FullerSizes>(curve.sizes.value()).exponent, 0.5);
  EXPECT_DOUBLE_EQ(curve.smallest.value(), 0.1e-3);
  EXPECT_DOUBLE_EQ(curve.largest.value(), 2e-3);
  const auto shorter = filler_with(R"(sizes = { fuller = "2 mm" }, from = "0.1 mm", to = "1 mm")");
  EXPECT_DOUBLE_EQ(shorter.largest.value(), 1e-3);
}

TEST_F(DeckSizes, ThreeQuantilesAreLognormalWhereTheMedianIsTheGeometricMean) {
  const auto cut = R"(, from = "0.1 mm", to = "2 mm")";
  const auto sigma = std::log(4.0) / 1.2815515655446004;
  const auto lognormal =
      fmt::format("sizes = {{ lognormal = [{{ median = \"0.4 mm\", sigma = {:.17g} }}] }}{}", sigma, cut);
  expect_near(drawn(test::join(R"(sizes = { d10 = "0.1 mm", d50 = "0.4 mm", d90 = "1.6 mm" })", cut)), drawn(lognormal),
              1e-12);
}

// Of the particles that the sieve of 1 mm retains, 20 % of 60 % pass that of 2 mm.
TEST_F(DeckSizes, ACutLeavesOutWhatHasNoSize) {
  const auto fines = R"(sizes = { passing = [{ size = "1 mm", passing = "40 %" }, { size = "2 mm", passing = "60 %" },
  { size = "4 mm", passing = "100 %" }] })";
  EXPECT_THAT(mistakes_of(fines),
              HasSubstr("stages.a.filler.sizes: 40 % of the volume pass 1 mm, the smallest size, and have no sizes: "
                        "expected a row with 0 %, the size that nothing passes, or from = \"1 mm\""));
  EXPECT_NEAR(distribution(test::join(fines, ", from = \"1 mm\"")).cumulative(2e-3), 0.2 / 0.6, 1e-15);
  EXPECT_NEAR(distribution(test::join(fines, ", from = \"2 mm\"")).cumulative(2.828427124746190e-3), 0.5, 1e-12);
  EXPECT_THAT(mistakes_of(test::join(fines, ", from = \"0.5 mm\"")), HasSubstr("40 % of the volume pass 1 mm"));
  directory.write("coarse.csv", "size [mm],passing [%]\n1,0\n2,60\n4,98\n");
  EXPECT_THAT(mistakes_of("sizes = \"coarse.csv\""),
              HasSubstr("2 % of the volume do not pass 4 mm, the largest size, and have no sizes: expected a row with "
                        "100 %, or to = \"4 mm\""));
  EXPECT_NEAR(distribution("sizes = \"coarse.csv\", to = \"4 mm\"").cumulative(2e-3), 0.6 / 0.98, 1e-15);
}

TEST_F(DeckSizes, ThePanBelowTheSievesIsNoSize) {
  directory.write("pan.csv", "size [mm],passing [%]\n4,100\n2,60\n1,0\n0,0\n");
  EXPECT_EQ(filler_with("sizes = \"pan.csv\"").smallest, 1e-3);
  directory.write("pan.csv", "size [mm],passing [%]\n4,100\n2,60\n0,3\n");
  EXPECT_THAT(mistakes_of("sizes = \"pan.csv\""), HasSubstr("expected a positive diameter"));
}

// The default gap is a tenth of the smallest diameter that there is, not of the finest sieve.
TEST_F(DeckSizes, SievesThatNothingPassesOrThatAllPassAreNoSizes) {
  const auto filler =
      filler_with(R"(sizes = { passing = [{ size = "63 um", passing = "0 %" }, { size = "0.5 mm", passing = "0 %" },
  { size = "1 mm", passing = "30 %" }, { size = "2 mm", passing = "100 %" }, { size = "4 mm", passing = "100 %" }] })");
  EXPECT_EQ(filler.smallest, 0.5e-3);
  EXPECT_EQ(filler.largest, 2e-3);
  EXPECT_NEAR(filler.gap, 0.05e-3, 1e-15);
  EXPECT_NEAR(distribution_of(filler).value().cumulative(1e-3), 0.3, 1e-15);
}

TEST_F(DeckSizes, MistakesInASieveAnalysis) {
  const auto mistakes_in = [&](std::string_view rows) {
    return mistakes_of(test::join("sizes = { passing = [", rows, "] }"));
  };
  EXPECT_THAT(mistakes_in(R"({ size = "1 mm", passing = 0 }, { size = "1 mm", passing = 1 })"),
              HasSubstr("filler.sizes.passing.1.size: expected a diameter that no other row has"));
  EXPECT_THAT(mistakes_in(R"({ size = "1 mm", passing = 1 }, { size = "2 mm", passing = 0 })"),
              HasSubstr("filler.sizes.passing.1.passing: expected a volume fraction that is not below that up to a "
                        "smaller diameter"));
  EXPECT_THAT(mistakes_in(R"({ size = "1 mm", passing = 40 }, { size = "2 s", passing = 1 }, { size = "3 mm" })"),
              AllOf(HasSubstr("passing.0.passing: expected a number from 0 to 1, or per cent as in \"35 %\", got 40"),
                    HasSubstr("passing.1.size: expected a length, got \"2 s\""),
                    HasSubstr("passing.2.passing: missing"), Not(HasSubstr("filler.sizes: "))))
      << "all of them, and nothing that follows from them";
  EXPECT_THAT(mistakes_in(R"({ size = "1 mm", passing = 1 })"),
              HasSubstr("filler.sizes.passing: expected at least two rows"));
  EXPECT_THAT(mistakes_in(R"(["1 mm", "5 %"])"), HasSubstr("filler.sizes.passing.0: expected a table"));
  EXPECT_THAT(mistakes_in(R"({ size = "1 mm", passing = 0 }, { size = "2 mm", passing = 0 })"),
              HasSubstr("100 % of the volume do not pass 2 mm"));
  directory.write("twice.csv", "size [mm],passing [%]\n1,0\n2,100\n1,5\n");
  EXPECT_THAT(mistakes_of("sizes = \"twice.csv\""),
              HasSubstr("twice.csv:4: expected a diameter that no other row has"));
}

TEST_F(DeckSizes, MistakesInLaws) {
  EXPECT_THAT(mistakes_of(R"(sizes = { d10 = "2 mm", d50 = "1 mm", d90 = "1 mm" }, from = "1 mm", to = "2 mm")"),
              AllOf(HasSubstr("filler.sizes.d50: expected more than 2 mm (d10), got 1 mm"),
                    HasSubstr("filler.sizes.d90: expected more than 1 mm (d50), got 1 mm")));
  EXPECT_THAT(mistakes_of(R"(sizes = { d50 = "1 mm", d90 = "2 mm" }, from = "1 mm", to = "2 mm")"),
              HasSubstr("filler.sizes.d10: missing, expected a length"));
  EXPECT_THAT(mistakes_of(R"(sizes = { d10 = "1 mm", d50 = "2 mm", d90 = "3 mm" })"),
              AllOf(HasSubstr("filler.from: missing"), HasSubstr("filler.to: missing")));
  EXPECT_THAT(mistakes_of(R"(sizes = { fuller = "2 mm" })"),
              AllOf(HasSubstr("filler.from: missing"), Not(HasSubstr("filler.to: missing"))));
  EXPECT_THAT(
      mistakes_of(R"(sizes = { fuller = "2 mm", exponent = -1 }, from = "1 mm")"),
      AllOf(HasSubstr("filler.sizes.exponent: expected a positive number, got -1"), Not(HasSubstr("filler.sizes: "))));
  EXPECT_THAT(mistakes_of(R"(sizes = { fuller = "2 mm" }, from = "3 mm")"),
              HasSubstr("filler.from: expected less than 2 mm (to), got 3 mm"));
  EXPECT_THAT(mistakes_of(R"(sizes = { rosin_rammler = "1 mm" }, from = "1 mm", to = "2 mm")"),
              HasSubstr("filler.sizes.exponent: missing"));
  EXPECT_THAT(mistakes_of(R"(sizes = { rosin_rammler = "1 m", exponent = 3 }, from = "1 um", to = "2 um")"),
              HasSubstr("filler.sizes: size distribution: nothing of it (less than 1e-9) has diameters"));
  EXPECT_THAT(mistakes_of(R"(sizes = { from = "2 mm", to = "1 mm" })"),
              HasSubstr("filler.sizes.to: expected more than 2 mm (from), got 1 mm"));
  EXPECT_THAT(mistakes_of(R"(sizes = { from = "2 mm" })"), HasSubstr("filler.sizes.to: missing"));
  EXPECT_THAT(mistakes_of(R"(sizes = { fuller = "2 mm", d50 = "1 mm" }, from = "1 mm")"),
              HasSubstr("filler.sizes.fuller: expected exactly one of diameter, list, passing, d50, lognormal, fuller, "
                        "rosin_rammler, from, got d50 and fuller"));
}

}  // namespace
}  // namespace breccia
