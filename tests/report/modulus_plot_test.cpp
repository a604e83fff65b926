#include "report/modulus_plot.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "report/xml.hpp"

namespace breccia {
namespace {

using test::count;
using test::xml_mistake;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

PlotCurve relaxation(const std::string& label, double modulus, PlotStyle style = PlotStyle::line) {
  PlotCurve curve{label, {}, {}, style, {}};
  for (int i = 0; i <= 60; ++i) {
    const double t = std::pow(10.0, -8.0 + 0.1 * i);
    curve.times.push_back(t);
    curve.moduli.push_back(modulus * std::pow(1.0 + t / 1e-6, -0.15));
  }
  return curve;
}

std::string message_of(const ModulusPlot& plot) {
  try {
    modulus_plot(plot);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ModulusPlot, IsWellFormedAndNamesItsCurvesAndAxes) {
  const auto svg = modulus_plot(
      {"HB-1", {relaxation("displacement", 3e9), relaxation("traction", 2e9, PlotStyle::dashed)}, {}, "Shear modulus"});
  EXPECT_EQ(xml_mistake(svg), "");
  EXPECT_THAT(svg, HasSubstr(">displacement<"));
  EXPECT_THAT(svg, HasSubstr(">traction<"));
  EXPECT_THAT(svg, HasSubstr(">HB-1<"));
  EXPECT_THAT(svg, HasSubstr(">Time / s<"));
  EXPECT_THAT(svg, HasSubstr(">Shear modulus / MPa<"));
}

TEST(ModulusPlot, ShowsOtherQuantitiesInTheirUnits) {
  ModulusPlot plot{"creep", {{"J(t)", {1.0, 10.0, 100.0}, {1e-9, 1e-8, 1e-7}}}, {}, "Creep compliance"};
  plot.unit = "(1/GPa)";
  plot.unit_size = 1e-9;
  plot.abscissa = "Hours / h";
  const auto svg = modulus_plot(plot);
  EXPECT_THAT(svg, HasSubstr(">Creep compliance / (1/GPa)<"));
  EXPECT_THAT(svg, HasSubstr(">Hours / h<"));
  EXPECT_THAT(svg, HasSubstr(">100<"));
}

TEST(ModulusPlot, IsTheSameForTheSameInput) {
  const ModulusPlot plot{"", {relaxation("a", 1e6)}, {}};
  EXPECT_EQ(modulus_plot(plot), modulus_plot(plot));
}

TEST(ModulusPlot, ShowsLabelsAsTheyAreWritten) {
  const std::string label = R"(it's "50%" & <2 µm>, a_b^c {d} $e @f `g` \n)";
  const auto svg = modulus_plot({label, {relaxation(label, 1e6)}, {{label, 1e-7, 1e-5}}});
  EXPECT_EQ(xml_mistake(svg), "");
  EXPECT_GE(count(svg, R"(>it's "50%" &amp; &lt;2 µm>, a_b^c {d} $e @f `g` \n</text>)"), 3) << "title, legend, window";
}

TEST(ModulusPlot, LeavesOutWhatLogarithmicAxesCannotShow) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto svg = modulus_plot(
      {"",
       {{"kept", {0.0, 1.0, 2.0, infinity, 4.0}, {9e6, 3e6, -1.0, 1e6, 1e6}}, {"nothing to show", {0.0}, {1e6}}},
       {}});
  EXPECT_EQ(xml_mistake(svg), "");
  EXPECT_THAT(svg, HasSubstr(">kept<"));
  EXPECT_THAT(svg, Not(HasSubstr(">nothing to show<")));
}

TEST(ModulusPlot, LabelsItsAxesWithRoundNumbers) {
  const auto within_two_decades = modulus_plot({"", {{"a", {1e-3, 1e-1}, {30e6, 300e6}}}});
  for (const auto* label : {">0.001<", ">0.002<", ">0.05<", ">0.1<", ">50<", ">100<", ">200<"}) {
    EXPECT_THAT(within_two_decades, HasSubstr(label));
  }
  const auto over_many_decades = modulus_plot({"", {{"a", {1e-9, 1e-2}, {1e0, 1e9}}}});
  EXPECT_EQ(count(over_many_decades, ">10<tspan"), 8 + 5) << "every decade of time, every second one of modulus";
}

TEST(ModulusPlot, PutsAPointWhereTheAxesHaveItsValue) {
  // Both axes have the second point in their middle.
  const auto svg = modulus_plot({"", {{"a", {1.0, 10.0, 100.0}, {1e6, 1e7, 1e8}}}});
  EXPECT_THAT(svg,
              AllOf(HasSubstr("L486.00 228.00"), HasSubstr("M486.00 438.00V18.00"), HasSubstr("M102.00 228.00H870.00")))
      << "the point, and the lines of the grid at 10 s and 10 MPa";
}

TEST(ModulusPlot, MarksTheVisiblePartOfAWindow) {
  const auto svg = modulus_plot(
      {"", {{"a", {1.0, 100.0}, {1e6, 1e8}}}, {{"first", 0.01, 10.0}, {"second", 10.0, 1e5}, {"unseen", 1e3, 1e5}}});
  EXPECT_THAT(svg, AllOf(HasSubstr(R"(<rect x="102.00" y="18.00" width="384.00" height="420.00")"),
                         HasSubstr(R"(<rect x="486.00" y="18.00" width="384.00" height="420.00")"),
                         HasSubstr(">first</text>"), HasSubstr(">second</text>"), Not(HasSubstr(">unseen</text>"))));
}

TEST(ModulusPlot, GivesLabelsOfWindowsThatWouldTouchRowsOfTheirOwn) {
  const std::string label = "a window with a long label";
  const auto svg = modulus_plot({"", {{"a", {1.0, 100.0}, {1e6, 1e8}}}, {{label, 9.0, 10.0}, {label, 10.0, 11.0}}});
  EXPECT_THAT(svg, AllOf(HasSubstr(R"(y="34.00">a window)"), HasSubstr(R"(y="50.00">a window)")));
}

TEST(ModulusPlot, SqueezesATextThatIsWiderThanItsPlace) {
  const auto svg = modulus_plot({std::string(300, 'm'), {{"a", {1.0, 100.0}, {1e6, 1e8}}}});
  EXPECT_THAT(svg, HasSubstr(R"( textLength="768" )"));
}

TEST(ModulusPlot, GrowsWithTheRowsOfItsLegend) {
  const auto with_curves = [](int count) {
    ModulusPlot plot;
    for (int i = 0; i < count; ++i) plot.curves.push_back(relaxation("a curve with a label of thirty", 1e6));
    return modulus_plot(plot);
  };
  EXPECT_THAT(with_curves(2), HasSubstr(R"(viewBox="0 0 900 542")"));
  EXPECT_THAT(with_curves(4), HasSubstr(R"(viewBox="0 0 900 564")"));
}

// The palette has seven colours.
TEST(ModulusPlot, TellsCurvesOfOneColourApartByTheirDashes) {
  for (const auto style : {PlotStyle::line, PlotStyle::dashed}) {
    const auto with_colour = [&](std::size_t colour) {
      auto curve = relaxation("a", 1e6, style);
      curve.colour = colour;
      return modulus_plot({"", {curve}, {}});
    };
    const std::set<std::string> plots = {with_colour(2), with_colour(9), with_colour(16), with_colour(23)};
    EXPECT_EQ(plots.size(), 4U);
  }
}

TEST(ModulusPlot, DrawsASinglePoint) {
  EXPECT_EQ(xml_mistake(modulus_plot({"", {{"one", {1.0}, {1e6}, PlotStyle::points}}, {}})), "");
}

TEST(ModulusPlot, RefusesWhatItCannotDraw) {
  EXPECT_THROW(modulus_plot({}), InputError);
  EXPECT_THROW(modulus_plot({"", {{"empty", {}, {}}}, {}}), InputError);
  EXPECT_EQ(message_of({"", {{"G(t)", {1.0, 2.0}, {1e6}}}, {}}), "plot: the curve \"G(t)\" has 2 times but 1 moduli");
}

}  // namespace
}  // namespace breccia
