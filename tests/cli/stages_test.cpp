#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/io/csv.hpp"
#include "breccia/io/text_file.hpp"

#include "model_deck.hpp"
#include "study_directory.hpp"

namespace breccia::test {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

/// A box without particles is its matrix: whatever the stage before it became must come out again.
const std::string passing_on = std::string(model_deck) + R"(
[[stages]]
name   = "B"
matrix = "A"
box    = "60 mm"
cells  = 8
)";

using Key = std::tuple<std::string, std::string, std::string>;  // stage, boundary, method

/// G(t) [Pa] of stages by boundary and method.
std::map<Key, std::vector<double>> shear_moduli(const StudyDirectory& study) {
  const auto table = read_csv(study.result("curves.csv"), {"stage", "load", "boundary", "method", "cells"});
  std::map<Key, std::vector<double>> moduli;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text("load")[row] != "shear") continue;
    moduli[{table.text("stage")[row], table.text("boundary")[row], table.text("method")[row]}].push_back(
        table.numbers("modulus_Pa")[row]);
  }
  return moduli;
}

/// Largest relative difference between stage B and stage A.
double worst_difference(const StudyDirectory& study, const std::string& boundary, const std::string& method) {
  const auto moduli = shear_moduli(study);
  const auto& first = moduli.at({"A", boundary, method});
  const auto& second = moduli.at({"B", boundary, method});
  EXPECT_EQ(first.size(), second.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    worst = std::max(worst, std::abs(second[i] / first[i] - 1.0));
  }
  return worst;
}

TEST(Stages, AStagePassesOnWhatItBecameUnderEachBoundary) {
  StudyDirectory study(passing_on);
  const auto run = study.breccia(
      "run", {"--set", "tests.method=quasistatic", "--set", R"(tests.bounds=["upper", "lower", "periodic"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto provenance = Json::parse(read_text(study.result("study.json")));
  const auto& passed_on = provenance["stages"][0]["materials"];
  ASSERT_EQ(passed_on.size(), 3U);
  for (const auto& material : passed_on) {
    const double fit_error = material["shear_fit_error"];
    const std::string boundary = material["boundary"];
    EXPECT_LT(fit_error, 1e-3) << boundary;
    // The bounds themselves are tens of per cent apart.
    EXPECT_LT(worst_difference(study, boundary, "quasistatic"), 2.0 * fit_error + 1e-5) << boundary;
    EXPECT_DOUBLE_EQ(material["material"]["density_kg_per_m3"], 1000.0 + 500.0 * 4.0 * M_PI / 36.0);
  }
  EXPECT_TRUE(provenance["stages"][1]["materials"].empty());
}

TEST(Stages, TheDynamicMethodPassesOnItsOwnResult) {
  StudyDirectory study(passing_on);
  const auto run = study.breccia("run", {"--set", R"(tests.times=["3 ms", "30 ms"])"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_LT(worst_difference(study, "displacement", "dynamic"), 0.02);
}

TEST(Stages, ExtrapolatedResultsArePassedOn) {
  StudyDirectory study(passing_on);
  const auto run = study.breccia("run", {"--set", "tests.method=quasistatic", "--set", "stages.A.cells=[24, 48]"});
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const auto table = read_csv(study.result("curves.csv"), {"stage", "load", "boundary", "method", "cells"});
  std::map<double, double> extrapolated;
  double worst = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double time = table.numbers("time_s")[row], modulus = table.numbers("modulus_Pa")[row];
    if (table.text("load")[row] == "bulk") continue;
    if (table.text("cells")[row] == "extrapolated") extrapolated[time] = modulus;
    if (table.text("stage")[row] == "B") worst = std::max(worst, std::abs(modulus / extrapolated.at(time) - 1.0));
  }
  EXPECT_LT(worst, 1e-3);
}

TEST(Stages, ABadFitStopsTheStudyAndKeepsWhatIsDone) {
  StudyDirectory study(passing_on);
  const auto run = study.breccia("run", {"--set", "tests.method=quasistatic", "--set", "tests.fit_tolerance=1e-12"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.errors, HasSubstr("stage A, upper bound, quasistatic: the fit of G(t)"));
  EXPECT_THAT(run.errors, HasSubstr("tests.fit_tolerance"));
  EXPECT_THAT(shear_moduli(study), ::testing::SizeIs(1));
}

TEST(Stages, ThePlanOfALaterStageIsAGuess) {
  StudyDirectory study(passing_on);
  const auto check = study.breccia("check", {"--set", R"(tests.method=["quasistatic", "dynamic"])"});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, HasSubstr("B upper bound, quasi-static"));
  EXPECT_THAT(check.output, HasSubstr("B shear, upper bound, dynamic"));
  EXPECT_THAT(check.output, HasSubstr("A bulk, upper bound, dynamic"));
}

}  // namespace
}  // namespace breccia::test
