#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "model_deck.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

using test::StudyDirectory;
using ::testing::HasSubstr;
using Json = nlohmann::json;

namespace fs = std::filesystem;

/// The data of the study in a page.
Json data_of(const std::string& page) {
  const std::string begin = R"(id="data">)";
  const auto from = page.find(begin) + begin.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

test::Outcome report(const StudyDirectory& study, const std::string& directory = "out") {
  return test::run_breccia(study.path(), {"report", directory});
}

/// The results of a quasi-static run of the model composite.
class Report : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto run = study.breccia(
        "run",
        {"--set", "tests.method=quasistatic", "--set", "stages.A.cells=8", "--set",
         R"(materials.binder.temperature_shift={law="wlf",c1=6.5,c2="120 K",reference="0 degC",temperature="10 degC"})"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
  }

  StudyDirectory study{test::model_deck};
};

TEST_F(Report, ContainsTheResultsOnTheDisk) {
  const auto data = data_of(read_text(study.result("report.html")));
  EXPECT_EQ(data.at("study"), Json::parse(read_text(study.result("study.json"))));
  EXPECT_EQ(data.at("study").at("complete"), true);
  const auto curves = read_csv(study.result("curves.csv"), {"stage", "load", "boundary", "method", "cells"});
  const auto& shown = data.at("tables").at("curves.csv");
  EXPECT_EQ(shown.at("modulus_Pa"), Json(curves.numbers("modulus_Pa")));
  EXPECT_EQ(shown.at("boundary"), Json(curves.text("boundary")));
  EXPECT_EQ(data.at("pictures").at("A"), read_text(study.result("A/microstructure.svg")));
  const auto& response = data.at("responses").at("A").at(0);
  EXPECT_EQ(response.at("boundary"), "displacement");
  EXPECT_EQ(response.at("filler_Pa").size(), response.at("load_forces").size());
}

TEST_F(Report, ShowsDateAndAccuracy) {
  const auto record = Json::parse(read_text(study.result("study.json")));
  EXPECT_THAT(record.at("date").get<std::string>(),
              ::testing::MatchesRegex("20[0-9][0-9]-[01][0-9]-[0-3][0-9]T[0-2][0-9]:[0-5][0-9]:[0-6][0-9]Z"));
  const auto& stage = record.at("stages").at(0);
  EXPECT_DOUBLE_EQ(stage.at("microstructure").at("largest_diameter_m"), 2e-3);
  const auto& quality = stage.at("quality");
  EXPECT_THAT(quality.at("summary").get<std::string>(),
              HasSubstr("grid: one grid, error unknown, no rule for a binder that falls faster than 1/t^2 (cells = [8, "
                        "16] measures it)"));
  EXPECT_EQ(quality.at("seeds"), nullptr) << "a regular packing has none";
  const auto curve = test::read_curve(study.result("curves.csv"), "A", "shear");
  const auto& bounds = quality.at("bounds").at(0);
  EXPECT_EQ(bounds.at("first").at("time_s"), 1e-3);
  EXPECT_NEAR(bounds.at("last").at("upper_Pa").get<double>() / curve.back().modulus, 1.0, 1e-3);
  EXPECT_EQ(bounds.at("last").at("lower_Pa"), nullptr);
}

TEST_F(Report, ShowsTheTemperatureShift) {
  const auto study_record = Json::parse(read_text(study.result("study.json")));
  const auto& shift = study_record.at("materials").at(0).at("temperature_shift");
  EXPECT_DOUBLE_EQ(shift.at("c1"), 6.5);
  EXPECT_DOUBLE_EQ(shift.at("c2_K"), 120.0);
  EXPECT_DOUBLE_EQ(shift.at("reference_K"), 273.15);
  EXPECT_DOUBLE_EQ(shift.at("temperature_K"), 283.15);
  EXPECT_FALSE(study_record.at("materials").at(1).contains("temperature_shift"));
}

TEST_F(Report, IsTheSameWhenWrittenAnew) {
  const auto first = read_text(study.result("report.html"));
  fs::remove(study.result("report.html"));
  const auto outcome = report(study);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "out/report.html\n");
  EXPECT_EQ(read_text(study.result("report.html")), first);
}

TEST_F(Report, RefusesFilesOfDifferentStudies) {
  auto record = Json::parse(read_text(study.result("study.json")));
  record["hash"] = "0123456789abcdef";
  write_text(study.result("study.json"), record.dump());
  const auto outcome = report(study);
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.errors, HasSubstr("out/A/response.h5: of another study (hash "));
}

TEST_F(Report, RefusesInvalidRecords) {
  for (const auto* text :
       {"{", "[]", "{}", R"({"title": 1, "hash": "", "stages": []})", R"({"title": "", "hash": ""})"}) {
    write_text(study.result("study.json"), text);
    const auto outcome = report(study);
    EXPECT_EQ(outcome.exit_code, 4) << text;
    EXPECT_THAT(outcome.errors, HasSubstr("out/study.json: not as `breccia run` writes it")) << text;
  }
}

TEST(ReportCommand, SaysWhereThereAreNoResults) {
  const StudyDirectory study(test::model_deck);
  const auto nothing = report(study, ".");
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_EQ(nothing.errors, ".: no study.json or sweep.json, which `breccia run` leaves with its results\n");
  EXPECT_THAT(report(study, "nowhere").errors, HasSubstr("nowhere: no study.json"));
}

TEST(ReportCommand, OfASweepHoldsTheCurvesOfItsTasks) {
  const StudyDirectory study(std::string(test::model_deck) + "[sweep]\n\"stages.A.cells\" = [8, 12]\n");
  ASSERT_EQ(study.breccia("run", {"--set", "tests.method=quasistatic"}).exit_code, 0);
  const auto first = read_text(study.result("report.html"));
  const auto data = data_of(first);
  EXPECT_EQ(data.at("sweep"), Json::parse(read_text(study.result("sweep.json"))));
  ASSERT_EQ(data.at("curves").size(), 2U);
  EXPECT_EQ(data.at("curves").at(1).at("task"), 1);
  EXPECT_EQ(data.at("curves").at(1).at("cells"), "12");
  EXPECT_EQ(data.at("curves").at(1).at("time_s").size(), data.at("curves").at(1).at("modulus_Pa").size());
  EXPECT_EQ(report(study).exit_code, 0);
  EXPECT_EQ(read_text(study.result("report.html")), first);
  const auto record = read_text(study.result("sweep.json"));
  write_text(study.result("sweep.json"), R"({"title": ""})");
  EXPECT_THAT(report(study).errors, HasSubstr("out/sweep.json: not as `breccia run` writes it"));
  write_text(study.result("sweep.json"), record);
  // A single run that replaces the sweep leaves no file of it.
  study.write("deck.toml", std::string(test::model_deck));
  ASSERT_EQ(study.breccia("run", {"--overwrite", "--set", "tests.method=quasistatic"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(study.result("sweep.json")));
}

TEST(ReportCommand, HoldsTheHistoriesOfDynamicRuns) {
  const StudyDirectory study(test::model_deck);
  ASSERT_EQ(study.breccia("run", {"--set", "stages.A.cells=8"}).exit_code, 0);
  const auto data = data_of(read_text(study.result("report.html")));
  const auto& runs = data.at("histories").at("A");
  ASSERT_FALSE(runs.empty());
  EXPECT_EQ(runs.at(0).at("load"), "shear");
  EXPECT_EQ(runs.at(0).at("domain"), 0);
  EXPECT_EQ(runs.at(0).at("time_s").size(), runs.at(0).at("value").size());
}

TEST(ReportCommand, AStudyThatIsPackedHasOneToo) {
  const StudyDirectory study(test::model_deck);
  ASSERT_EQ(study.breccia("pack").exit_code, 0);
  EXPECT_EQ(report(study).exit_code, 0);
  EXPECT_EQ(data_of(read_text(study.result("report.html"))).at("study").at("complete"), false);
}

}  // namespace
}  // namespace breccia
