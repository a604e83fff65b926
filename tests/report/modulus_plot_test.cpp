#include "breccia/report/modulus_plot.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/io/text_file.hpp"

#include "report/xml.hpp"
#include "scoped_path.hpp"

namespace breccia {
namespace {

using test::count;
using test::ScopedPath;
using test::xml_mistake;
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
  const auto svg = modulus_plot({"HB-1",
                                 {relaxation("upper bound", 3e9), relaxation("lower bound", 2e9, PlotStyle::dashed)},
                                 {},
                                 "Shear modulus"});
  EXPECT_EQ(xml_mistake(svg), "");
  EXPECT_THAT(svg, HasSubstr(">upper bound<"));
  EXPECT_THAT(svg, HasSubstr(">lower bound<"));
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

TEST(ModulusPlot, DoesNotExecuteLabels) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "breccia-label-was-executed";
  std::filesystem::remove(file);
  for (const std::string attack : {"'\nsystem 'touch FILE'\n#", "`touch FILE`", "'.system('touch FILE').'"}) {
    auto label = attack;
    label.replace(label.find("FILE"), 4, file.string());
    EXPECT_EQ(xml_mistake(modulus_plot({label, {relaxation(label, 1e6)}, {{label, 1e-7, 1e-5}}, label})), "");
    EXPECT_FALSE(std::filesystem::exists(file)) << attack;
  }
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
  EXPECT_EQ(count(over_many_decades, ">10</tspan>"), 8 + 5) << "every decade of time, every second one of modulus";
}

// There are seven colours.
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

TEST(ModulusPlot, SaysWhatToInstallWithoutGnuplot) {
  EXPECT_EQ(why_no_plots(), std::nullopt);
  const ScopedPath path("/nonexistent");
  EXPECT_THAT(why_no_plots(), ::testing::Optional(HasSubstr("apt-get install gnuplot-nox")));
  EXPECT_THAT(message_of({"", {relaxation("a", 1e6)}, {}}), HasSubstr("apt-get install gnuplot-nox"));
}

TEST(ModulusPlot, ReportsTheErrorsOfGnuplot) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "breccia-failing-gnuplot";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\necho 'no terminal svg' >&2\nexit 3\n";
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
  const ScopedPath path(folder.string());
  EXPECT_THAT(message_of({"", {relaxation("a", 1e6)}, {}}), HasSubstr("status 3: no terminal svg;"));
  const auto file = folder / "modulus.svg";
  std::ofstream(file) << "of a run before";
  EXPECT_THAT(write_modulus_plot(file, {"", {relaxation("a", 1e6)}, {}}), ::testing::Optional(HasSubstr("status 3")));
  EXPECT_FALSE(std::filesystem::exists(file)) << "it would show other results";
}

TEST(ModulusPlot, IsWrittenToAFile) {
  const ModulusPlot plot{"", {relaxation("a", 1e6)}, {}};
  const auto file = std::filesystem::path(::testing::TempDir()) / "breccia-plot.svg";
  EXPECT_EQ(write_modulus_plot(file, plot), std::nullopt);
  EXPECT_EQ(read_text(file), modulus_plot(plot));
  EXPECT_THROW(write_modulus_plot(file / "below a file.svg", plot), FileError);
}

}  // namespace
}  // namespace breccia
