#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "messages.hpp"
#include "model_deck.hpp"
#include "study_directory.hpp"
#include "tables/csv.hpp"

namespace breccia::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using Json = nlohmann::json;

const std::vector<std::string> quasistatic{"--set", "tests.method=quasistatic",
                                           "--set", R"(tests.boundaries=["displacement", "traction", "periodic"])",
                                           "--set", R"(tests.loads=["shear", "bulk"])"};

std::vector<std::string> with(const std::vector<std::string>& more) {
  auto all = quasistatic;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// One value of a table of results; the rows of each test are in order of time.
struct Row {
  std::string load, boundary, cells;
  double time, value;
};

std::vector<Row> rows_of(const std::filesystem::path& file, const std::string& column) {
  const auto table = read_csv(file, {"stage", "load", "boundary", "method", "cells"});
  std::vector<Row> rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    rows.push_back({table.text("load")[row], table.text("boundary")[row],
                    table.has("cells") ? table.text("cells")[row] : "", table.numbers("time_s")[row],
                    table.numbers(column)[row]});
  }
  return rows;
}

std::vector<Row> only(const std::vector<Row>& rows, const std::string& load, const std::string& boundary,
                      const std::string& cells = "24") {
  std::vector<Row> some;
  for (const auto& row : rows) {
    if (row.load == load && row.boundary == boundary && row.cells == cells) some.push_back(row);
  }
  return some;
}

/// The model composite by the quasi-static method under all boundaries and two loads.
class Quasistatic : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study = std::make_unique<StudyDirectory>(model_deck);
    run = study->breccia("run", quasistatic);
  }
  static void TearDownTestSuite() { study.reset(); }
  void SetUp() override { ASSERT_EQ(run.exit_code, 0) << run.errors; }

  static inline std::unique_ptr<StudyDirectory> study;
  static inline Outcome run;
};

TEST_F(Quasistatic, LeavesTheseFiles) {
  std::vector<std::string> expected = {"A/bulk_modulus.svg",
                                       "A/labels.npy",
                                       "A/labels.vti",
                                       "A/microstructure.csv",
                                       "A/microstructure.svg",
                                       "A/modulus.svg",
                                       "A/response.h5",
                                       "checksums.txt",
                                       "compliance.csv",
                                       "curves.csv",
                                       "dynamic.csv",
                                       "engineering.csv",
                                       "engineering_dynamic.csv",
                                       "prony.csv",
                                       "errors.csv",
                                       "quality.csv",
                                       "report.html",
                                       "study.json"};
  for (const auto* fields : {"A/fields", "A/fields-traction-quasistatic", "A/fields-periodic-quasistatic"}) {
    for (const auto* ending : {".vtkhdf", "-stress.svg", "-strain.svg"}) {
      expected.push_back(std::string(fields) + ending);
    }
  }
  EXPECT_THAT(study->results(), ::testing::UnorderedElementsAreArray(expected));
}

TEST_F(Quasistatic, BoundsOfTheShearModulusAreInOrder) {
  // Energy bounds order the moduli at every real Laplace variable; in time the order holds where they are well apart.
  const auto rows = rows_of(study->result("curves.csv"), "modulus_Pa");
  const auto lower = only(rows, "shear", "traction"), between = only(rows, "shear", "periodic"),
             upper = only(rows, "shear", "displacement");
  ASSERT_EQ(lower.size(), upper.size());
  for (std::size_t i = 0; i < lower.size(); ++i) {
    EXPECT_LT(lower[i].value, between[i].value);
    EXPECT_LT(between[i].value, upper[i].value);
  }
  // The expected values are from an independent computation with standard points and 24 cells.
  EXPECT_NEAR(only(rows, "shear", "displacement").front().value / 0.884355e6, 1.0, 1e-4);
}

TEST_F(Quasistatic, CreepIsSlowerThanTheInverseOfRelaxation) {
  const auto moduli = only(rows_of(study->result("curves.csv"), "modulus_Pa"), "shear", "traction");
  const auto compliances = only(rows_of(study->result("compliance.csv"), "compliance_1_per_Pa"), "shear", "traction");
  ASSERT_EQ(moduli.size(), compliances.size());
  for (std::size_t i = 0; i < moduli.size(); ++i) EXPECT_LT(moduli[i].value * compliances[i].value, 1.0);
}

TEST_F(Quasistatic, SeriesAgreeWithCurves) {
  const auto table = read_csv(study->result("prony.csv"), {"stage", "load", "boundary"});
  for (const auto& row : rows_of(study->result("curves.csv"), "modulus_Pa")) {
    double modulus = 0.0;
    for (std::size_t i = 0; i < table.rows(); ++i) {
      if (table.text("load")[i] != row.load || table.text("boundary")[i] != row.boundary) continue;
      modulus += table.numbers("modulus_Pa")[i] * std::exp(-row.time / table.numbers("relaxation_time_s")[i]);
    }
    EXPECT_NEAR(modulus / row.value, 1.0, 1e-12);
  }
}

TEST_F(Quasistatic, ProvenanceRecordsSnapshotsAndResiduals) {
  const auto json = Json::parse(read_text(study->result("study.json")));
  const auto& test = json["stages"][0]["tests"][0];
  EXPECT_EQ(test["solver"], "reduced");
  EXPECT_EQ(test["linear"]["method"], "direct");
  EXPECT_LT(test["linear"]["largest_residual"].get<double>(), 1e-9);
  EXPECT_GE(test["snapshots"].size(), 4U);
  EXPECT_LT(test["snapshots"].back()["error_before"].get<double>(), 1e-5);
  EXPECT_LT(test["error_estimate"].get<double>(), 1e-5);
}

TEST_F(Quasistatic, RespondGivesTheSameWithTheSameMatrixAndTheRunWithAnother) {
  // At another temperature all relaxation times are ten times as long, and so are those of the response.
  study->write("slow.toml",
               "density = \"1 g/cm^3\"\nbulk = \"1 MPa\"\n"
               "shear = { terms = [{ time = \"100 ms\", modulus = \"0.5 MPa\" }] }\n");
  const auto respond = run_breccia(
      study->path(), {"respond", "out", "--material", "slow.toml", "--times", "10 ms", "500 ms", "--out", "slow"});
  ASSERT_EQ(respond.exit_code, 0) << respond.errors;
  EXPECT_THAT(respond.output, HasSubstr("with slow as matrix"));
  const auto before = rows_of(study->result("curves.csv"), "modulus_Pa");
  const auto after = rows_of(study->path() / "slow/curves.csv", "modulus_Pa");
  ASSERT_EQ(before.size(), after.size());
  for (const auto& row : before) {
    const auto same = only(after, row.load, row.boundary);
    const auto found = std::ranges::find_if(same, [&](const Row& other) { return other.time > 9.999 * row.time; });
    ASSERT_NE(found, same.end());
    EXPECT_NEAR(found->value / row.value, 1.0, 1e-9);
  }
}

TEST_F(Quasistatic, RespondRefusesBadArguments) {
  study->write("stiff.toml", "density = \"1 g/cm^3\"\nbulk = \"1 MPa\"\nshear = \"3 GPa\"\n");
  study->write("bad.toml", "bulk = \"1 um\"\n");
  const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes = {
      {{"out", "--material", "stiff.toml"}, "stiff shows a shear modulus of 3 GPa; the responses hold from"},
      {{"out", "--material", "bad.toml"}, R"(bulk: expected a pressure, got "1 um")"},
      {{"out", "--material", "none.toml"}, "none.toml"},
      {{"nowhere", "--material", "stiff.toml"}, "nowhere: no such directory"},
      {{"out/A", "--material", "stiff.toml"}, "out/A: no prony.csv, which a run writes after its first test"},
      {{"out", "--material", "stiff.toml", "--stage", "B"}, R"(no response of a stage "B")"},
      {{"out", "--material", "stiff.toml", "--times", "1 s", "1 ms"}, "expected two rising times"},
      {{"out", "--material", "nofile.toml"}, "nofile.toml: no such file"},
      {{"out"}, "--material"}};
  for (auto [arguments, message] : mistakes) {
    arguments.insert(arguments.begin(), "respond");
    const auto outcome = run_breccia(study->path(), arguments);
    EXPECT_EQ(outcome.exit_code, 2) << message;
    EXPECT_THAT(outcome.errors, HasSubstr(message));
  }
}

TEST(QuasistaticRun, SteppingAgreesWithTheReducedBasis) {
  const StudyDirectory study(model_deck);
  const auto small = with({"--set", "stages.A.cells=12"});
  ASSERT_EQ(study.breccia("run", small).exit_code, 0);
  const auto reduced = rows_of(study.result("curves.csv"), "modulus_Pa");
  auto stepping = small;
  stepping.insert(stepping.end(),
                  {"--overwrite", "--set", "tests.solver=stepping", "--set", "tests.quasistatic.steps_per_decade=80"});
  const auto run = study.breccia("run", stepping);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto stepped = rows_of(study.result("curves.csv"), "modulus_Pa");
  ASSERT_EQ(stepped.size(), reduced.size());
  for (std::size_t i = 0; i < stepped.size(); ++i) {
    // The modulus follows from the creep compliance by a fit and interconversion.
    EXPECT_NEAR(stepped[i].value / reduced[i].value, 1.0, stepped[i].boundary == "traction" ? 1e-2 : 1e-3);
  }
  EXPECT_FALSE(std::filesystem::exists(study.result("A/response.h5")));
}

TEST(QuasistaticRun, SeveralGridsAreExtrapolated) {
  const StudyDirectory study(replaced(std::string(model_deck), "cells   = 24", "cells   = [12, 24, 48]"));
  const auto run = study.breccia("run", quasistatic);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto rows = rows_of(study.result("curves.csv"), "modulus_Pa");
  const auto medium = only(rows, "shear", "displacement", "24"), fine = only(rows, "shear", "displacement", "48"),
             limit = only(rows, "shear", "displacement", "extrapolated");
  ASSERT_EQ(limit.size(), fine.size());
  for (std::size_t i = 0; i < limit.size(); ++i) {
    EXPECT_NEAR(limit[i].value / (2.0 * fine[i].value - medium[i].value), 1.0, 1e-9);
  }
  const auto bands = rows_of(study.result("extrapolation.csv"), "half_band_Pa");
  EXPECT_EQ(bands.size(), 6 * limit.size());
  for (const auto& band : bands) EXPECT_GE(band.value, 0.0);
  EXPECT_THAT(study.results(), IsSupersetOf({"extrapolation.csv", "prony.csv"}));
}

TEST(QuasistaticRun, OptionsOfPetscReachIt) {
  const StudyDirectory study(model_deck);
  const auto run = study.breccia("run", with({"--petsc", "-quasistatic_pc_type nonsense"}));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.errors, HasSubstr("setting up the linear solver"));
}

TEST(QuasistaticRun, OptionsOfPetscThatAreNoneAreToldOf) {
  const StudyDirectory study(model_deck);
  const auto words = study.breccia("run", with({"--petsc", "ksp_monitor"}));
  EXPECT_EQ(words.exit_code, 2);
  EXPECT_THAT(words.errors, HasSubstr(R"(PETSc options: expected "-name value -name value ...", got "ksp_monitor")"));
  const auto misspelt = study.breccia("run", with({"--petsc", "-quasistatic_ksp_monitr"}));
  EXPECT_EQ(misspelt.exit_code, 0) << misspelt.errors;
  EXPECT_THAT(misspelt.output, HasSubstr("note: PETSc has not used -quasistatic_ksp_monitr\n"));
}

}  // namespace
}  // namespace breccia::test
