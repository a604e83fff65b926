#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

test::Outcome bench(std::vector<std::string> options) {
  const test::TemporaryDirectory directory;
  options.insert(options.begin(), "bench");
  return test::run_breccia(directory.path(), options);
}

/// Arguments for little work, with these options.
std::vector<std::string> quick(std::vector<std::string> options) {
  options.insert(options.end(), {"--seconds", "0.01", "--rounds", "2", "--points", "1024"});
  return options;
}

TEST(Bench, PrintsEveryCaseAsJson) {
  const auto outcome =
      bench(quick({"--json", "--terms", "0", "10", "--threads", "1", "2", "--instructions", "baseline"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json.at("processes"), 1);
  EXPECT_EQ(json.at("clock"), "wall time");
  ASSERT_THAT(json.at("memory"), SizeIs(2));
  EXPECT_EQ(json.at("memory")[1].at("threads"), 2);
  EXPECT_THAT(json.at("memory")[1].at("rounds"), SizeIs(2));
  EXPECT_GT(json.at("memory")[0].at("median").at("triad_bytes_per_s"), 0.0);
  ASSERT_THAT(json.at("kernels"), SizeIs(8));
  const auto& kernel = json.at("kernels")[2];
  EXPECT_EQ(kernel.at("formulation"), "total-lagrangian");
  EXPECT_EQ(kernel.at("instructions"), "baseline");
  EXPECT_EQ(kernel.at("points"), 1024);
  EXPECT_EQ(kernel.at("terms"), 10);
  EXPECT_EQ(kernel.at("threads"), 1);
  EXPECT_THAT(kernel.at("points_x_steps_per_s").at("rounds"), SizeIs(2));
  EXPECT_EQ(json.at("kernels")[7].at("formulation"), "classical");
}

TEST(Bench, MeasuresEveryRequestedCase) {
  const auto outcome = bench({"--json", "--formulation", "total-lagrangian", "classical", "--points", "256", "1024",
                              "--terms", "1", "--threads", "1", "--seconds", "0.01", "--rounds", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  std::vector<std::pair<std::string, int>> cases;
  const auto json = nlohmann::json::parse(outcome.output);
  for (const auto& kernel : json.at("kernels")) {
    cases.emplace_back(kernel.at("formulation"), kernel.at("points"));
  }
  EXPECT_THAT(cases, testing::UnorderedElementsAre(testing::Pair("total-lagrangian", 256),
                                                   testing::Pair("total-lagrangian", 1024),
                                                   testing::Pair("classical", 256), testing::Pair("classical", 1024)));
}

TEST(Bench, MeasuresMixedCellsBesidePoints) {
  const auto outcome = bench(quick({"--json", "--formulation", "total-lagrangian", "--terms", "5", "--threads", "1",
                                    "--mixing", "series", "points"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  ASSERT_THAT(json.at("kernels"), SizeIs(2));
  EXPECT_EQ(json.at("kernels")[0].at("mixing"), "series");
  EXPECT_EQ(json.at("kernels")[1].at("mixing"), "points");
}

TEST(Bench, MeasuresBoxesOfThreeDimensions) {
  const auto outcome = bench(quick({"--json", "--dimensions", "2", "3", "--terms", "1", "--threads", "1"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  ASSERT_THAT(json.at("kernels"), SizeIs(4));
  const auto& kernel = json.at("kernels")[1];
  EXPECT_EQ(kernel.at("formulation"), "total-lagrangian");
  EXPECT_EQ(kernel.at("dimensions"), 3);
  EXPECT_EQ(kernel.at("points"), 1000);
}

TEST(Bench, TenTermsTakeLessThan300BytesAPoint) {
  const auto outcome = bench({"--json", "--terms", "10", "--threads", "1", "--seconds", "0.01", "--rounds", "1",
                              "--points", "99856", "--mixing", "points"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  for (const auto& kernel : json.at("kernels")) {
    EXPECT_LT(kernel.at("bytes_per_point"), 300.0) << kernel;
  }
}

TEST(Bench, PrintsATable) {
  const auto outcome =
      bench(quick({"--formulation", "total-lagrangian", "--terms", "3", "--threads", "1", "--processor-time"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("1 process, processor time"));
  EXPECT_THAT(outcome.output, HasSubstr("memory bandwidth [GB/s]"));
  EXPECT_THAT(outcome.output, testing::ContainsRegex("total-lagrangian +[a-z0-9]+ +series +2 +1024 +3 +1 +[0-9.]+"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("classical")));
}

TEST(Bench, MistypedOptions) {
  const std::vector<std::pair<std::vector<std::string>, const char*>> cases{
      {{"--points", "12"}, "--points"},     {{"--points", "many"}, "--points"},
      {{"--terms", "-1"}, "--terms"},       {{"--terms", "2.5"}, "--terms"},
      {{"--threads", "0"}, "--threads"},    {{"--instructions", "mmx"}, "--instructions"},
      {{"--formulation", "fast"}, "fast"},  {{"--seconds", "0"}, "--seconds"},
      {{"--mixing", "stirred"}, "stirred"}, {{"--dimensions", "4"}, "--dimensions"},
      {{"--rounds", "0"}, "--rounds"},      {{"--jason"}, "--jason"},
      {{"deck.toml"}, "deck.toml"},
  };
  for (const auto& [options, message] : cases) {
    const auto outcome = bench(options);
    EXPECT_EQ(outcome.exit_code, 2) << message;
    EXPECT_THAT(outcome.errors, HasSubstr(message));
    EXPECT_EQ(outcome.output, "") << message;
  }
}

}  // namespace
}  // namespace breccia
