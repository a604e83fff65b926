// Tests of images of microstructures, and of the labels of material points, through the command line.

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/rasters/raster_reader.hpp"

#include "io/text_file.hpp"
#include "rasters/npy.hpp"
#include "rasters/png.hpp"
#include "study_directory.hpp"

namespace breccia {
namespace {

using test::run_breccia;
using test::StudyDirectory;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view materials = R"(
[materials.binder]
density = "1.48 g/cm^3"
bulk    = "3.6 GPa"
shear   = { terms = [ { time = "10 ms", modulus = "1 MPa" } ], equilibrium = "10 kPa" }
[materials.hmx]
density = "1.85 g/cm^3"
bulk    = "13.4 GPa"
shear   = "5.84 GPa"
[materials.interphase]
density = "1.6 g/cm^3"
bulk    = "4 GPa"
shear   = "20 MPa"
)";

constexpr std::string_view tests = R"(
[tests]
loads = ["shear"]
times  = ["10 us", "100 ms"]
points_per_decade = 3
fields = "none"
mixing = "points"
)";

std::string deck_of(std::string_view stage) {
  return fmt::format("{}\n[[stages]]\nname = \"A\"\nmatrix = \"binder\"\n{}\n{}", materials, stage, tests);
}

/// A stage whose image is the labels that another stage has written, with the label 0 for the matrix and these further
/// labels.
std::string stage_of_labels(std::string_view file, std::string_view walls, std::string_view labels) {
  return fmt::format(
      "box = \"1 mm\"\npacking = {{ method = \"image\", file = \"{}\", periodic = {}, labels = [{{ value = 0, material "
      "= "
      "\"binder\" }}, {}] }}",
      file, walls, labels);
}

/// A microstructure, and its labels other than that of the matrix.
struct Original {
  std::string name;
  std::string stage;
  std::string periodic;
  std::string labels;
  std::string array;  ///< the further array of labels.vti
};

class LabelsOf : public testing::TestWithParam<Original> {};

// The image has the same points, so that G(t) is bitwise identical.
TEST_P(LabelsOf, AMicrostructureAreReadBack) {
  const auto& [name, stage, periodic, labels, array] = GetParam();
  const StudyDirectory original(deck_of(stage));
  const auto run = original.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto curves = read_text(original.result("curves.csv"));
  for (const std::string file : {"labels.npy", "labels.vti"}) {
    const StudyDirectory image(deck_of(stage_of_labels(file, periodic, labels)));
    image.write(file, read_text(original.result("A/" + file)));
    const auto again = image.breccia("run");
    ASSERT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(read_text(image.result("curves.csv")), curves) << file;
    EXPECT_EQ(read_raster(image.result("A/labels.npy")).values, read_raster(original.result("A/labels.npy")).values);
  }
  const auto particles = read_raster(original.result("A/labels.vti"), array);
  EXPECT_EQ(std::ranges::min(particles.values), -1) << "the matrix";
  EXPECT_GT(std::ranges::max(particles.values), 1);
}

INSTANTIATE_TEST_SUITE_P(
    Image, LabelsOf,
    testing::Values(
        Original{
            "Discs",
            "box = \"1 mm\"\ncells = 33\nfiller = { material = \"hmx\", fraction = 0.5, sizes = { diameter = \"0.25 "
            "mm\" } }\npacking = { method = \"lubachevsky-stillinger\", walls = true }",
            "false", "{ value = 1, material = \"hmx\" }", "particle"},
        Original{
            "CoatedDiscs",
            "box = \"1 mm\"\ncells = 40\nfiller = { material = \"hmx\", fraction = 0.4, sizes = { diameter = \"0.25 "
            "mm\" }, coating = { material = \"interphase\", thickness = \"30 um\" } }\npacking = { method = "
            "\"lubachevsky-stillinger\", walls = false }",
            "true", "{ value = 1, material = \"hmx\" }, { value = 2, material = \"interphase\" }", "particle"},
        Original{"Grains",
                 "box = \"1 mm\"\ncells = 48\nfiller = { material = \"hmx\", fraction = 0.85, sizes = { diameter = "
                 "\"0.3 mm\" } }\npacking = { method = \"laguerre\" }",
                 "true", "{ value = 1, material = \"hmx\" }", "grain"}),
    [](const auto& chosen) { return chosen.param.name; });

/// A picture in which the pixels whose middle is in one of two discs have the colour 1 of the palette.
std::string picture_of_discs(int pixels) {
  std::vector<std::uint8_t> rows;
  for (int row = pixels; row-- > 0;) {
    for (int column = 0; column < pixels; ++column) {
      const double x = (column + 0.5) / pixels, y = (row + 0.5) / pixels;
      rows.push_back(std::hypot(x - 0.3, y - 0.25) <= 0.2 || std::hypot(x - 0.62, y - 0.66) <= 0.3 ? 1 : 0);
    }
  }
  return encode_png(static_cast<std::size_t>(pixels), rows, std::array{Rgb{255, 255, 255}, Rgb{200, 30, 30}});
}

constexpr auto two_discs = R"(box = "1 mm"
cells = 32
filler = { material = "hmx" }
packing = { method = "explicit", discs = "discs.csv" })";

std::string image_of_discs(std::string_view file, std::string_view cells = "") {
  return fmt::format(
      "{}\npacking = {{ method = \"image\", file = \"{}\", pixel = \"{}\", periodic = false, labels = [{{ value = 0, "
      "material "
      "= \"binder\" }}, {{ value = 1, material = \"hmx\" }}] }}",
      cells, file, "15.625 um");
}

TEST(Image, OfDiscsHasTheirPoints) {
  const StudyDirectory discs(deck_of(two_discs));
  discs.write("discs.csv", "x_mm,y_mm,diameter_mm\n0.3,0.25,0.4\n0.62,0.66,0.6\n");
  const StudyDirectory image(deck_of(image_of_discs("discs.png")));
  image.write("discs.png", picture_of_discs(64));
  const auto of_discs = discs.breccia("run"), of_image = image.breccia("run");
  ASSERT_EQ(of_discs.exit_code, 0) << of_discs.errors;
  ASSERT_EQ(of_image.exit_code, 0) << of_image.errors;
  EXPECT_EQ(read_text(image.result("curves.csv")), read_text(discs.result("curves.csv")));
  EXPECT_THAT(of_image.output, AllOf(HasSubstr("A: pixels of the filler fill 40."), HasSubstr("of 4096 points")));
  EXPECT_EQ(of_image.output.find("inf"), std::string::npos);
}

TEST(Image, OfFinerPixelsComesNearerToTheShapes) {
  const std::vector<std::string> one_bound = {"--set", "tests.mixing=series", "--set",
                                              R"(tests.boundaries=["displacement"])"};
  const StudyDirectory discs(deck_of(two_discs));
  discs.write("discs.csv", "x_mm,y_mm,diameter_mm\n0.3,0.25,0.4\n0.62,0.66,0.6\n");
  const auto run = discs.breccia("run", one_bound);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto exact = test::read_curve(discs.result("curves.csv"), "A", "shear");
  double last_error = std::numeric_limits<double>::infinity();
  for (const int pixels : {32, 128, 1024}) {
    const StudyDirectory image(deck_of(
        "box = \"1 mm\"\ncells = 32\npacking = { method = \"image\", file = \"discs.png\", labels = [{ value = 0, "
        "material = \"binder\" }, { value = 1, material = \"hmx\" }] }"));
    image.write("discs.png", picture_of_discs(pixels));
    const auto of_image = image.breccia("run", one_bound);
    ASSERT_EQ(of_image.exit_code, 0) << of_image.errors;
    const auto curve = test::read_curve(image.result("curves.csv"), "A", "shear");
    double error = 0.0;
    for (const auto& sample : exact) {
      error = std::max(error, std::abs(test::modulus_at(curve, sample.time) / sample.modulus - 1.0));
    }
    EXPECT_LT(error, 0.5 * last_error) << pixels;
    last_error = error;
  }
  EXPECT_LT(last_error, 5e-3);
}

/// G(t) of layers under a shear along them, by the sum of their creep compliances. The matrix with the share f is a
/// standard linear solid of 10 kPa and 1 MPa with the relaxation time 10 ms; the others are elastic and add the
/// compliance c [1/Pa].
double modulus_of_layers(double time, double f, double c) {
  const double soft = 1e4, hard = 1.01e6;  // [Pa]
  const double first = f / hard + c, last = f / soft + c;
  const double retardation = 10e-3 * hard / soft;  // [s]
  return 1.0 / last + (1.0 / first - 1.0 / last) * std::exp(-time * last / (retardation * first));
}

std::string layers(std::string_view lines) {
  return deck_of(
      fmt::format("{}\npacking = {{ method = \"image\", file = \"layers.npy\", pixel = \"10 um\", periodic = true, "
                  "labels = [{{ value = 10, material = \"interphase\" }}, {{ value = 20, material = \"binder\" "
                  "}}, {{ value = 30, material = \"hmx\" }}] }}",
                  lines));
}

/// An image of horizontal layers: the value of each row of pixels, from the top.
void write_layers(const StudyDirectory& study, const std::vector<std::uint16_t>& rows) {
  const std::array<std::size_t, 2> extents = {rows.size(), rows.size()};
  std::vector<std::uint16_t> values;  // values of the rows from the bottom
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) values.insert(values.end(), rows.size(), *row);
  write_npy(study.path() / "layers.npy", extents, values);
}

void expect_modulus_of_layers(const StudyDirectory& study, double binder, double interphase, double hmx) {
  for (const auto& [time, modulus] : test::read_curve(study.result("curves.csv"), "A", "shear")) {
    EXPECT_NEAR(modulus / modulus_of_layers(time, binder, interphase / 20e6 + hmx / 5.84e9), 1.0, 1e-6) << time;
  }
}

TEST(Image, OfThreeLayersIsExact) {
  const StudyDirectory study(layers(""));
  write_layers(study, {10, 10, 20, 20, 20, 20, 20, 20, 30, 30, 30, 30});
  const auto points = study.breccia("run");
  ASSERT_EQ(points.exit_code, 0) << points.errors;
  expect_modulus_of_layers(study, 0.5, 1.0 / 6.0, 1.0 / 3.0);
}

// Series mixtures are exact for layers, wherever these lie in the cells.
TEST(Image, OfThreeLayersAcrossCellsIsExact) {
  const StudyDirectory study(layers("cells = 6"));
  write_layers(study, {10, 10, 10, 20, 20, 20, 20, 30, 30, 30, 30, 30});
  const auto series = study.breccia("run", {"--set", "tests.mixing=series"});
  ASSERT_EQ(series.exit_code, 0) << series.errors;
  expect_modulus_of_layers(study, 1.0 / 3.0, 0.25, 5.0 / 12.0);
}

TEST(Image, IsRecorded) {
  const StudyDirectory study(layers(""));
  write_layers(study, {10, 10, 20, 20, 20, 20, 20, 20, 30, 30, 30, 30});
  const auto pack = study.breccia("pack");
  ASSERT_EQ(pack.exit_code, 0) << pack.errors;
  EXPECT_THAT(study.results(), ElementsAre("A/labels.npy", "A/labels.vti", "A/microstructure.svg",
                                           "A/packing.checkpoint.h5", "study.json"));
  const auto stage = nlohmann::json::parse(read_text(study.result("study.json")))["stages"][0];
  EXPECT_TRUE(stage["microstructure"]["particles"].is_null());
  EXPECT_THAT(stage["microstructure"]["pixels"], ElementsAre(12, 12));
  EXPECT_NEAR(stage["microstructure"]["interface_per_area_1_per_m"].get<double>(), 3.0 / 120e-6, 1e-6);
  EXPECT_NEAR(stage["fillers"][0]["fraction"].get<double>(), 1.0 / 6.0, 1e-12);
  EXPECT_THAT(read_text(study.result("A/microstructure.svg")), HasSubstr("an image of 12 x 12 pixels"));
  const auto check = study.breccia("check");
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, AllOf(HasSubstr("layers.npy, 12 x 12 pixels of 10 um, periodic"), HasSubstr("hmx")));
}

TEST(Image, ThatChangesIsAnotherStudy) {
  const StudyDirectory study(layers(""));
  write_layers(study, {10, 10, 20, 20, 20, 20, 20, 20, 30, 30, 30, 30});
  ASSERT_EQ(study.breccia("run").exit_code, 0);
  const auto same = study.breccia("run", {"--resume"});
  EXPECT_EQ(same.exit_code, 0) << same.errors;
  EXPECT_THAT(same.output, HasSubstr("are complete"));
  write_layers(study, {10, 20, 20, 20, 20, 20, 20, 20, 30, 30, 30, 30});
  const auto changed = study.breccia("run", {"--resume"});
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_THAT(changed.errors, HasSubstr("layers.npy"));
}

TEST(Image, IsSwept) {
  const StudyDirectory study(layers(""));
  write_layers(study, {10, 10, 20, 20, 20, 20, 20, 20, 30, 30, 30, 30});
  std::filesystem::copy(study.path() / "layers.npy", study.path() / "first.npy");
  write_layers(study, {10, 10, 20, 20, 20, 30, 30, 30, 30, 30, 30, 30});
  const auto sweep = study.breccia("run", {"--sweep", R"(stages.A.packing.file=["first.npy", "layers.npy"])", "--sweep",
                                           R"(stages.A.packing.pixel=["10 um", "20 um"])"});
  ASSERT_EQ(sweep.exit_code, 0) << sweep.errors;
  EXPECT_TRUE(std::filesystem::exists(study.result("sweep.csv")));
}

/// Writes a noisy picture of two discs: grey values around 200 before a ground around 60, above a bar of 8 black rows.
void write_micrograph(const StudyDirectory& study) {
  constexpr int pixels = 64, bar = 8;
  std::mt19937_64 random(5);
  std::vector<std::uint16_t> values(std::size_t{pixels} * bar, 0);  // rows from the bottom
  for (int row = 0; row < pixels; ++row) {
    for (int column = 0; column < pixels; ++column) {
      const double x = (column + 0.5) / pixels, y = (row + 0.5) / pixels;
      const bool is_disc = std::hypot(x - 0.3, y - 0.25) <= 0.2 || std::hypot(x - 0.62, y - 0.66) <= 0.3;
      const int noise = static_cast<int>(random() % 101) - 50;
      values.push_back(static_cast<std::uint16_t>((is_disc ? 200 : 60) + noise));
    }
  }
  write_npy(study.path() / "discs.npy", std::array<std::size_t, 2>{pixels, pixels + bar}, values);
}

std::string grey_stage(std::string_view keys) {
  return fmt::format(
      "packing = {{ method = \"image\", file = \"discs.npy\", pixel = \"15.625 um\", labels = {{ dark = \"binder\", "
      "bright "
      "= \"hmx\" }}, {} }}",
      keys);
}

constexpr auto crop = "crop = { left = 0, top = 0, width = 64, height = 64 }";

TEST(Image, ThatIsGreyIsDividedAtAThreshold) {
  const StudyDirectory labels(deck_of(image_of_discs("discs.png")));
  labels.write("discs.png", picture_of_discs(64));
  const StudyDirectory grey(deck_of(grey_stage(fmt::format("threshold = \"otsu\", periodic = false, {}", crop))));
  write_micrograph(grey);
  ASSERT_EQ(labels.breccia("run").exit_code, 0);
  const auto run = grey.breccia("run");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(read_text(grey.result("curves.csv")), read_text(labels.result("curves.csv")))
      << "noise of 50 of 140 values";
  EXPECT_THAT(run.output, AllOf(HasSubstr("dark = binder, "), HasSubstr("bright = hmx, 41.0 %"),
                                HasSubstr("grey values 150 to 250")));
  const auto stage = nlohmann::json::parse(read_text(grey.result("study.json")))["stages"][0]["microstructure"];
  EXPECT_EQ(stage["threshold"]["method"], "otsu");
  EXPECT_EQ(stage["threshold"]["value"], 129.5) << "the middle of 110 and 149, between which no pixel is";
  EXPECT_EQ(stage["threshold"]["bright"]["material"], "hmx");
  EXPECT_NEAR(stage["threshold"]["bright"]["fraction"].get<double>(), stage["fraction"].get<double>(), 1e-12);
  EXPECT_THAT(read_text(grey.result("report.html")), HasSubstr("threshold 129.5 (Otsu)"));
  const auto check =
      grey.breccia("check", {"--set", "stages.A.packing.threshold=120", "--set", "stages.A.packing.smooth=3"});
  EXPECT_THAT(check.output,
              AllOf(HasSubstr("grey     threshold 120 of the medians of 3 x 3 pixels"),
                    HasSubstr("crop     64 x 64 pixels, from 0 right of the left side and 0 below the top"),
                    HasSubstr("sides    they cut ")));
}

TEST(Image, ThatIsGreyIsPeriodicByDefault) {
  const StudyDirectory grey(deck_of(grey_stage(fmt::format("threshold = \"otsu\", {}", crop))));
  write_micrograph(grey);
  const auto check = grey.breccia("check");
  ASSERT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, AllOf(HasSubstr("64 x 64 pixels of 15.625 um, periodic"), HasSubstr("boundary periodic")));
}

TEST(Image, ThatIsGreyMayHaveAFrame) {
  const StudyDirectory grey(
      deck_of(grey_stage("threshold = \"otsu\", crop = { left = 0, top = 8, width = 64, height = 64 }")));
  write_micrograph(grey);
  const auto check = grey.breccia("check");
  ASSERT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output + check.errors,
              HasSubstr("the outermost 8 lines of pixels at a side of the picture have one "
                        "grey value throughout"));
}

TEST(Image, ThatIsGreyTellsItsMistakes) {
  const auto mistakes = [](std::string_view keys) {
    const StudyDirectory grey(deck_of(grey_stage(keys)));
    write_micrograph(grey);
    const auto check = grey.breccia("check");
    EXPECT_EQ(check.exit_code, 2) << keys;
    return check.errors;
  };
  EXPECT_THAT(
      mistakes("threshold = \"otsu\""),
      HasSubstr("stages.A.packing.file: expected a square image, since boxes are square, got 64 x 72 pixels; crop "
                "= { left = 0, top = 0, width = 64, height = 64 } takes a square of it"));
  EXPECT_THAT(mistakes(fmt::format("threshold = 300, {}", crop)),
              HasSubstr("stages.A.packing.threshold: expected a threshold from 10 to below 250, the darkest and the "
                        "brightest grey value, got 300"));
  EXPECT_THAT(mistakes(fmt::format("threshold = 0.45, {}", crop)),
              HasSubstr("packing.threshold: expected a threshold on the scale of the grey values, here from 10 to 250, "
                        "got 0.45"));
  EXPECT_THAT(mistakes("threshold = 100, smooth = 4, crop = { left = 60, top = 0, width = 64 }"),
              AllOf(HasSubstr("packing.smooth: expected an odd number"),
                    HasSubstr("packing.crop.height: missing, expected an integer")));
  EXPECT_THAT(mistakes("threshold = 100, crop = { left = 60, top = 0, width = 64, height = 64 }"),
              HasSubstr("packing.crop: the pixels 60 to 124 from the left reach beyond a picture of 64 x 72"));
}

}  // namespace
}  // namespace breccia
