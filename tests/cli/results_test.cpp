#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "good_deck.hpp"
#include "io/hdf5.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "model_deck.hpp"
#include "report/xml.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

using test::StudyDirectory;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Lt;
using ::testing::SizeIs;
using Json = nlohmann::json;

/// The lines of a text without comments.
std::vector<std::string> data_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with('#')) lines.push_back(line);
  }
  return lines;
}

double mean(const std::vector<double>& values, std::size_t component, std::size_t components) {
  const std::size_t points = values.size() / components;
  double sum = 0.0;
  for (std::size_t point = 0; point < points; ++point) sum += values[components * point + component];
  return sum / static_cast<double>(points);
}

/// The results of one run of the model composite under shear, then bulk, up to 10 ms.
class Results : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study = std::make_unique<StudyDirectory>(test::model_deck);
    run = study->breccia("run", {"--set", R"(tests.loads=["shear", "bulk"])", "--set", "tests.times.1=10 ms"});
  }
  static void TearDownTestSuite() { study.reset(); }

  void SetUp() override { ASSERT_EQ(run.exit_code, 0) << run.errors; }
  [[nodiscard]] static std::filesystem::path path(const std::string& name) { return study->result(name); }
  [[nodiscard]] static Json provenance() { return Json::parse(read_text(path("study.json"))); }
  [[nodiscard]] static std::vector<std::string> names() { return study->results(); }

 private:
  static inline std::unique_ptr<StudyDirectory> study;
  static inline test::Outcome run;
};

TEST_F(Results, AreTheseFiles) {
  const auto tests = provenance()["stages"][0]["tests"];
  std::vector<std::string> expected{"A/labels.npy",
                                    "A/labels.vti",
                                    "A/bulk_modulus.svg",
                                    "A/fields-strain.svg",
                                    "A/fields-stress.svg",
                                    "A/fields.vtkhdf",
                                    "A/microstructure.csv",
                                    "A/microstructure.svg",
                                    "A/modulus.svg",
                                    "checksums.txt",
                                    "curves.csv",
                                    "dynamic.csv",
                                    "engineering.csv",
                                    "engineering_dynamic.csv",
                                    "prony.csv",
                                    "errors.csv",
                                    "quality.csv",
                                    "report.html",
                                    "study.json"};
  for (const auto& test : tests) {
    for (std::size_t i = 1; i <= test["time_domains"].size(); ++i) {
      expected.push_back("A/" + test["load"].get<std::string>() + "-displacement-dynamic-24-" + std::to_string(i) +
                         ".h5");
    }
  }
  EXPECT_THAT(names(), ::testing::UnorderedElementsAreArray(expected));
}

TEST_F(Results, CurvesAreATidyTable) {
  const auto lines = data_lines(read_text(path("curves.csv")));
  EXPECT_EQ(lines.front(), "stage,load,boundary,method,cells,time_s,modulus_Pa");
  EXPECT_THAT(lines[1], ::testing::StartsWith("A,shear,displacement,dynamic,24,0.001,"));
  EXPECT_THAT(lines.back(), ::testing::StartsWith("A,bulk,displacement,dynamic,24,0.01,"));
  EXPECT_THAT(lines, SizeIs(1 + 2 * 21)) << "20 a decade, both ends";
}

TEST_F(Results, ProvenanceRecordsTheRun) {
  const auto json = provenance();
  EXPECT_EQ(json["program"], "breccia");
  EXPECT_EQ(json["title"], "Model composite");
  EXPECT_EQ(json["deck_text"], test::model_deck);
  EXPECT_THAT(json["overrides"], ElementsAre(R"(tests.loads=["shear", "bulk"])", "tests.times.1=10 ms"));
  EXPECT_THAT(json["hash"].get<std::string>(), ::testing::MatchesRegex("[0-9a-f]+"));
  EXPECT_THAT(json["materials"], SizeIs(2));
  const auto& stage = json["stages"][0];
  EXPECT_THAT(stage["cells"], ElementsAre(24));
  EXPECT_EQ(stage["points"], 4 * 24 * 24);
  ASSERT_THAT(stage["warnings"], SizeIs(1));  // the discs are two cells from the walls
  EXPECT_THAT(stage["warnings"][0].get<std::string>(), HasSubstr("500 um, is 2 cells wide"));
  EXPECT_EQ(stage["microstructure"]["particles"], 4);
  EXPECT_NEAR(stage["microstructure"]["fraction"].get<double>(), std::acos(-1.0) / 9.0, 1e-12);
  EXPECT_NEAR(stage["microstructure"]["smallest_gap_cells"].get<double>(), 4.0, 1e-9);
}

TEST_F(Results, TimeDomainsOverlapAndCoverTheTimes) {
  const auto stage = provenance()["stages"][0];
  ASSERT_THAT(stage["tests"], SizeIs(2));
  EXPECT_EQ(stage["tests"][0]["load"], "shear");
  EXPECT_EQ(stage["tests"][1]["load"], "bulk");
  for (const auto& test : stage["tests"]) {
    const auto& domains = test["time_domains"];
    ASSERT_THAT(domains, SizeIs(Ge(2)));
    EXPECT_LE(domains.front()["valid_s"][0].get<double>(), 1e-3);
    EXPECT_GE(domains.back()["valid_s"][1].get<double>(), 10e-3);
    ASSERT_THAT(test["overlaps"], SizeIs(domains.size() - 1));
    for (std::size_t i = 1; i < domains.size(); ++i) {
      EXPECT_LT(domains[i - 1]["density_factor"].get<double>(), domains[i]["density_factor"].get<double>());
      EXPECT_LT(domains[i]["valid_s"][0].get<double>(), domains[i - 1]["valid_s"][1].get<double>());
      EXPECT_THAT(test["overlaps"][i - 1]["mismatch"].get<double>(), AllOf(Ge(0.0), Lt(0.03)));
    }
  }
}

TEST_F(Results, MicrostructureListsTheDiscs) {
  EXPECT_EQ(data_lines(read_text(path("A/microstructure.csv"))).front(), "x_m,y_m,diameter_m");
  const auto table = read_csv(path("A/microstructure.csv"));
  using ::testing::DoubleEq;
  EXPECT_THAT(table.numbers("x_m"),
              ElementsAre(DoubleEq(1.5e-3), DoubleEq(4.5e-3), DoubleEq(1.5e-3), DoubleEq(4.5e-3)));
  EXPECT_THAT(table.numbers("y_m"),
              ElementsAre(DoubleEq(1.5e-3), DoubleEq(1.5e-3), DoubleEq(4.5e-3), DoubleEq(4.5e-3)));
  EXPECT_THAT(table.numbers("diameter_m"), ::testing::Each(2e-3));
}

TEST_F(Results, PicturesAreWellFormed) {
  const auto picture = read_text(path("A/microstructure.svg"));
  EXPECT_EQ(test::xml_mistake(picture), "");
  EXPECT_EQ(test::count(picture, "<circle"), 4U);
  const auto plot = read_text(path("A/modulus.svg"));
  EXPECT_EQ(test::xml_mistake(plot), "");
  for (const auto* label : {"Model composite: A", "Relaxation modulus G(t)", "displacement", "matrix"}) {
    EXPECT_THAT(plot, HasSubstr(label));
  }
  const auto bulk_plot = read_text(path("A/bulk_modulus.svg"));
  EXPECT_EQ(test::xml_mistake(bulk_plot), "");
  EXPECT_THAT(bulk_plot, HasSubstr("Plane-strain bulk modulus K(t) + G(t)/3"));
}

TEST_F(Results, FieldsHoldTheDiscsAndAverageToTheLoad) {
  const Hdf5Reader fields(path("A/fields.vtkhdf"));
  const std::string data = "/VTKHDF/CellData/";
  const auto corners = fields.read_numbers("/VTKHDF/Points");
  const auto squares = fields.read_integers("/VTKHDF/Connectivity");
  std::vector<std::int64_t> expected;
  for (std::size_t square = 0; square < squares.size() / 4; ++square) {
    const auto at = [&](std::size_t corner, std::size_t axis) {
      return corners[3 * static_cast<std::size_t>(squares[4 * square + corner]) + axis];
    };
    const double x = 0.5 * (at(0, 0) + at(2, 0)), y = 0.5 * (at(0, 1) + at(2, 1));
    const double from_centre = std::hypot(std::fmod(x, 3e-3) - 1.5e-3, std::fmod(y, 3e-3) - 1.5e-3);
    expected.push_back(from_centre <= 1e-3 ? 1 : 0);
  }
  const auto material = fields.read_integers(data + "material");
  EXPECT_THAT(material, SizeIs(48U * 48U));
  EXPECT_THAT(material, ElementsAreArray(expected));
  EXPECT_NEAR(static_cast<double>(std::accumulate(material.begin(), material.end(), std::int64_t{0})) / (48.0 * 48.0),
              provenance()["stages"][0]["filler_point_fraction"].get<double>(), 1e-12);

  // The fields are those of the first load, a unit engineering shear strain. The stress is that at the last time, apart
  // from ringing.
  ASSERT_THAT(fields.shape(data + "strain"), ElementsAre(48U * 48U, 6U));
  constexpr std::size_t xx = 0, xy = 3;
  const auto strain = fields.read_numbers(data + "strain");
  EXPECT_NEAR(mean(strain, xy, 6), 0.5, 1e-7);
  EXPECT_NEAR(mean(strain, xx, 6), 0.0, 1e-7);
  const double modulus = test::read_curve(path("curves.csv"), "A", "shear").back().modulus;
  EXPECT_NEAR(mean(fields.read_numbers(data + "stress_Pa"), xy, 6) / modulus, 1.0, 0.03);
  EXPECT_THAT(fields.shape(data + "displacement_m"), ElementsAre(48U * 48U, 3U));

  const auto tests = provenance()["stages"][0]["tests"];
  EXPECT_EQ(tests[0]["fields"][0]["file"], "fields.vtkhdf");
  EXPECT_NEAR(fields.attribute<double>("/VTKHDF", "time_s") / 0.01, 1.0, 0.01);
  EXPECT_FALSE(tests[1].contains("fields")) << "of the first load alone";
}

TEST_F(Results, HistoriesRecordTheirTest) {
  const auto json = provenance();
  for (const auto& test : json["stages"][0]["tests"]) {
    const auto load = test["load"].get<std::string>();
    for (std::size_t i = 0; i < test["time_domains"].size(); ++i) {
      const auto& domain = test["time_domains"][i];
      const Hdf5Reader history(path("A/" + load + "-displacement-dynamic-24-" + std::to_string(i + 1) + ".h5"));
      EXPECT_EQ(history.attribute<std::string>("/history", "deck_hash"), json["hash"]);
      EXPECT_EQ(history.attribute<std::string>("/history", "stage"), "A");
      EXPECT_EQ(history.attribute<std::string>("/history", "load"), load);
      EXPECT_EQ(history.attribute<std::int64_t>("/history", "cells"), 24);
      EXPECT_EQ(history.attribute<std::int64_t>("/history", "steps"), domain["steps"]);
      EXPECT_EQ(history.attribute<double>("/history", "density_factor"), domain["density_factor"]);
      EXPECT_EQ(history.attribute<std::vector<double>>("/history", "valid_s"), domain["valid_s"]);
      const auto times = history.read_numbers("/history/time_s");
      EXPECT_TRUE(std::ranges::is_sorted(times, std::ranges::less_equal()));
      EXPECT_GE(times.back(), domain["valid_s"][1].get<double>());
      EXPECT_THAT(history.read_numbers("/history/modulus_Pa"), SizeIs(times.size()));
    }
  }
}

TEST(PackResults, AreTheMicrostructureAlone) {
  const StudyDirectory study(test::good_deck);
  const auto pack = study.breccia("pack", {"--set", "tests.mixing=series"});
  ASSERT_EQ(pack.exit_code, 0) << pack.errors;
  EXPECT_THAT(pack.output, HasSubstr("warning: A: the smallest gap between particles"));
  EXPECT_THAT(pack.output, HasSubstr("out/A/microstructure.svg"));
  EXPECT_THAT(study.results(), ElementsAre("A/labels.npy", "A/labels.vti", "A/microstructure.csv",
                                           "A/microstructure.svg", "A/packing.checkpoint.h5", "study.json"));
  const auto json = Json::parse(read_text(study.result("study.json")));
  const auto& stage = json["stages"][0];
  EXPECT_EQ(stage["microstructure"]["seed"], 1);
  EXPECT_THAT(stage["warnings"], SizeIs(2)) << "narrow gaps, few particles";
  EXPECT_THAT(stage["tests"], IsEmpty());
}

TEST(PackResults, DependOnTheSeedAlone) {
  const StudyDirectory study(test::good_deck);
  ASSERT_EQ(study.breccia("pack").exit_code, 0);
  const auto first = read_text(study.result("A/microstructure.csv"));
  ASSERT_EQ(study.breccia("pack").exit_code, 0);
  EXPECT_EQ(read_text(study.result("A/microstructure.csv")), first);
  ASSERT_EQ(study.breccia("pack", {"--set", "stages.A.packing.seed=2"}).exit_code, 0);
  EXPECT_NE(read_text(study.result("A/microstructure.csv")), first);
}

TEST(PackResults, AreAnExplicitPacking) {
  const StudyDirectory study(test::good_deck);
  ASSERT_EQ(study.breccia("pack").exit_code, 0);
  const auto first = read_text(study.result("A/microstructure.csv"));
  study.write("discs.csv", first);
  auto deck = std::string(test::good_deck);
  deck = test::replaced(deck, R"(, fraction = 0.5, sizes = { diameter = "1 mm" }, gap = "0.1 mm")", "");
  deck =
      test::replaced(deck, R"("lubachevsky-stillinger", walls = true, seed = 1)", R"("explicit", discs = "discs.csv")");
  study.write("deck.toml", deck);
  const auto pack = study.breccia("pack");
  ASSERT_EQ(pack.exit_code, 0) << pack.errors;
  EXPECT_EQ(read_text(study.result("A/microstructure.csv")), first);
  EXPECT_FALSE(Json::parse(read_text(study.result("study.json")))["stages"][0]["microstructure"].contains("seed"));
}

TEST(PackResults, AnEmptyBoxHasNoGap) {
  const StudyDirectory study(test::homogeneous_deck);
  ASSERT_EQ(study.breccia("pack").exit_code, 0);
  const auto stage = Json::parse(read_text(study.result("study.json")))["stages"][0];
  EXPECT_TRUE(stage["filler"].is_null());
  EXPECT_TRUE(stage["microstructure"]["smallest_gap_m"].is_null());
  EXPECT_EQ(data_lines(read_text(study.result("A/microstructure.csv"))).size(), 1U) << "only the header";
}

}  // namespace
}  // namespace breccia
