#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/hdf5.hpp"
#include "io/text_file.hpp"
#include "model_deck.hpp"
#include "report/xml.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

using test::StudyDirectory;
using ::testing::HasSubstr;
using Json = nlohmann::json;

const std::vector<std::string> all_bounds{"--set", "stages.A.cells=16",
                                          "--set", R"(tests.boundaries=["displacement", "traction", "periodic"])",
                                          "--set", R"(tests.times=["1 ms", "10 ms"])"};

std::vector<std::string> with(const std::vector<std::string>& more) {
  auto all = all_bounds;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Mean of twice the shear component of a tensor.
double mean_shear(const Hdf5Reader& fields, const std::string& name) {
  const auto values = fields.read_numbers("/VTKHDF/CellData/" + name);
  constexpr std::size_t xy = 3, components = 6;
  const auto tensors = values.size() / components;
  double sum = 0.0;
  for (std::size_t i = 0; i < tensors; ++i) sum += values[components * i + xy];
  return sum / static_cast<double>(tensors);
}

/// The value of a table for the first test under a boundary at a time.
double tabulated(const StudyDirectory& study, const std::string& boundary, double time) {
  const bool creeps = boundary == "traction";
  const auto table = read_csv(study.result(creeps ? "compliance.csv" : "curves.csv"),
                              {"boundary", "load", "stage", "method", "cells"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("boundary")[row] != boundary || std::abs(table.numbers("time_s")[row] / time - 1.0) > 1e-6) continue;
    return table.numbers(creeps ? "compliance_1_per_Pa" : "modulus_Pa")[row];
  }
  return std::nan("");
}

/// Expects the averages of every file of fields to agree with the tables. Returns the number of files.
int expect_averages(const StudyDirectory& study) {
  int files = 0;
  const auto record = Json::parse(read_text(study.result("study.json")));
  for (const auto& test : record.at("stages").at(0).at("tests")) {
    const auto boundary = test.at("boundary").get<std::string>();
    for (const auto& field : test.at("fields")) {
      const Hdf5Reader fields(study.result("A/" + field.at("file").get<std::string>()));
      const bool creeps = boundary == "traction";
      const double mean = creeps ? 2.0 * mean_shear(fields, "strain") : mean_shear(fields, "stress_Pa");
      const double time = field.at("time_s");
      EXPECT_EQ(fields.attribute<double>("/VTKHDF", "time_s"), time);
      EXPECT_NEAR(mean / tabulated(study, boundary, time), 1.0, 1e-6) << boundary << " " << time;
      for (const auto* picture : {"stress_picture", "strain_picture"}) {
        EXPECT_EQ(test::xml_mistake(read_text(study.result("A/" + field.at(picture).get<std::string>()))), "");
      }
      ++files;
    }
  }
  return files;
}

TEST(Fields, OfQuasistaticTestsAverageToTheirCurves) {
  const StudyDirectory study(test::model_deck);
  for (const auto* solver : {"reduced", "stepping"}) {
    const auto run = study.breccia(
        "run", with({"--overwrite", "--set", "tests.method=quasistatic", "--set", std::string("tests.solver=") + solver,
                     "--set", R"(tests.fields=["1 ms", "10 ms"])"}));
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(expect_averages(study), 6);
    EXPECT_THAT(study.results(),
                ::testing::IsSupersetOf({"A/fields.vtkhdf", "A/fields-1.vtkhdf", "A/fields-traction-quasistatic.vtkhdf",
                                         "A/fields-periodic-quasistatic-1-strain.svg"}));
  }
}

TEST(Fields, AreSavedAtTheLastTimeByDefaultAndNotWithNone) {
  const StudyDirectory study(test::model_deck);
  ASSERT_EQ(study.breccia("run", with({"--set", "tests.method=quasistatic"})).exit_code, 0);
  EXPECT_EQ(expect_averages(study), 3);
  const auto none = with({"--overwrite", "--set", "tests.method=quasistatic", "--set", "tests.fields=none"});
  ASSERT_EQ(study.breccia("run", none).exit_code, 0);
  for (const auto& name : study.results()) EXPECT_THAT(name, ::testing::Not(HasSubstr("fields")));
}

// Both methods have the same fields where waves are fast and the load rises slowly; the mean of the fields is
// quasi-static much earlier.
TEST(Fields, OfBothMethodsAgree) {
  const StudyDirectory study(test::model_deck);
  const auto run = study.breccia(
      "run", {"--set", "stages.A.cells=16", "--set", R"(tests.times=["2 ms", "20 ms"])", "--set",
              R"(tests.fields=["5 ms", "20 ms"])", "--set", R"(tests.method=["quasistatic", "dynamic"])", "--set",
              "tests.dynamic.mass_scaling_factors=[0.003]", "--set", "tests.dynamic.ramp_transits=6"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  for (const auto* number : {"-1", ""}) {
    const Hdf5Reader one(study.result(std::string("A/fields") + number + ".vtkhdf"));
    const Hdf5Reader other(study.result(std::string("A/fields-displacement-dynamic") + number + ".vtkhdf"));
    for (const auto* name : {"stress_Pa", "strain"}) {
      const auto a = one.read_numbers(std::string("/VTKHDF/CellData/") + name);
      const auto b = other.read_numbers(std::string("/VTKHDF/CellData/") + name);
      double difference = 0.0, size = 0.0;
      for (std::size_t i = 0; i < a.size(); ++i) {
        difference += (a[i] - b[i]) * (a[i] - b[i]);
        size += a[i] * a[i];
      }
      EXPECT_LT(std::sqrt(difference / size), 0.01) << name << number;
    }
  }
}

/// Two spheres in a rubber that relaxes.
constexpr std::string_view cube_deck = R"(
dimensions = 3
[materials.rubber]
density = "1.1 g/cm^3"
bulk    = "2 GPa"
shear   = { terms = [ { time = "1 ms", modulus = "90 MPa" } ], equilibrium = "10 MPa" }
[materials.glass]
density = "2.5 g/cm^3"
bulk    = "40 GPa"
shear   = "30 GPa"
[[stages]]
name    = "A"
matrix  = "rubber"
box     = "1 mm"
cells   = 8
filler  = { material = "glass", sizes = { list = ["0.45 mm", "0.5 mm"] }, gap = "50 um" }
packing = { method = "lubachevsky-stillinger", walls = true, seed = 1 }
[tests]
loads = ["shear"]
times      = ["0.1 ms", "10 ms"]
boundaries = ["displacement", "traction", "periodic"]
fields     = ["1 ms", "10 ms"]
points_per_decade = 2
)";

TEST(Fields, OfACubeAverageToTheirCurves) {
  const StudyDirectory study(std::string{cube_deck});
  for (const auto* solver : {"reduced", "stepping"}) {
    const auto run = study.breccia("run", {"--overwrite", "--set", std::string("tests.solver=") + solver});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(expect_averages(study), 6);
    EXPECT_THAT(study.results(), ::testing::IsSupersetOf({"A/fields.vtkhdf", "A/fields-1.vtkhdf",
                                                          "A/fields-traction-quasistatic-strain.svg"}));
  }
  EXPECT_THAT(read_text(study.result("A/fields-stress.svg")), HasSubstr("seen along y"));
  EXPECT_THAT(read_text(study.result("report.html")), HasSubstr("fields-periodic-quasistatic-1-strain.svg"));
  // No files of fields remain if none are requested.
  ASSERT_EQ(study.breccia("run", {"--overwrite", "--set", "tests.fields=none"}).exit_code, 0);
  for (const auto& name : study.results()) EXPECT_THAT(name, ::testing::Not(HasSubstr("fields")));
}

}  // namespace
}  // namespace breccia
