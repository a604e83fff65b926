#include "results/comparison_file.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "results/hand_made_results.hpp"
#include "results/stored_comparisons.hpp"
#include "tables/csv.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;

TEST(WriteComparisons, LeavesARowForEachTimeOfEachMeasurement) {
  const test::TemporaryDirectory directory;
  auto first = test::stage_with("A", {}), second = test::stage_with("B", {});
  first.comparisons = {{R"(Wetzel, "1999")",
                        {Load::shear, Boundary::displacement, Method::quasistatic, TestGrid::extrapolated()},
                        {{1e-3, 3e6, 2e6, 0.125}, {1.0, 1e6, 4e6}}}};
  second.comparisons = {
      {"rheometer", {Load::shear, Boundary::traction, Method::dynamic, TestGrid(24)}, {{0.1, 1.0, 3.0}}}};
  second.comparisons.front().kind = ModulusKind::young;
  write_comparisons(directory.path(), {{first, second}, {}});
  EXPECT_EQ(read_comparisons(directory.path()).at("B").front().kind, ModulusKind::young);
  const auto table = read_csv(directory.path() / "comparison.csv",
                              {"measurement", "modulus", "stage", "boundary", "method", "cells", "error"});
  EXPECT_THAT(table.names(), ElementsAre("measurement", "modulus", "stage", "boundary", "method", "cells", "time_s",
                                         "modulus_Pa", "measured_Pa", "ratio", "error"));
  EXPECT_THAT(table.text("measurement"), ElementsAre(R"(Wetzel, "1999")", R"(Wetzel, "1999")", "rheometer"));
  EXPECT_THAT(table.text("modulus"), ElementsAre("shear", "shear", "young"));
  EXPECT_THAT(table.text("stage"), ElementsAre("A", "A", "B"));
  EXPECT_THAT(table.text("boundary"), ElementsAre("displacement", "displacement", "traction"));
  EXPECT_THAT(table.text("method"), ElementsAre("quasistatic", "quasistatic", "dynamic"));
  EXPECT_THAT(table.text("cells"), ElementsAre("extrapolated", "extrapolated", "24"));
  EXPECT_THAT(table.numbers("time_s"), ElementsAre(1e-3, 1.0, 0.1));
  EXPECT_THAT(table.numbers("modulus_Pa"), ElementsAre(3e6, 1e6, 1.0));
  EXPECT_THAT(table.numbers("measured_Pa"), ElementsAre(2e6, 4e6, 3.0));
  EXPECT_THAT(table.numbers("ratio"), ElementsAre(1.5, 0.25, 1.0 / 3.0));
  EXPECT_THAT(table.text("error"), ElementsAre("0.125", "", ""));
  const auto read = read_comparisons(directory.path()).at("A").front().samples;
  EXPECT_EQ(read[0].error, 0.125);
  EXPECT_EQ(read[1].error, std::nullopt);
}

// 3 + 4i over 6 + 8i Pa at 1 Hz, and 1 + i over 1 Pa at 1 rad/s.
TEST(WriteComparisons, LeavesATableOfComplexModuli) {
  const test::TemporaryDirectory directory;
  auto stage = test::stage_with("A", {});
  const TestId id{Load::shear, Boundary::periodic, Method::quasistatic, TestGrid(24)};
  stage.comparisons = {
      {"rheometer", id, {}, {{1.0, 1.0, 1.0, 1.0, 1e-30}, {6.283185307179586, 3.0, 4.0, 6.0, 8.0, 0.5}}}};
  write_comparisons(directory.path(), {{stage}, {}});
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "comparison.csv"));
  const auto table = read_csv(directory.path() / "comparison_dynamic.csv",
                              {"measurement", "modulus", "stage", "boundary", "method", "cells", "error"});
  EXPECT_THAT(table.names(), ElementsAre("measurement", "modulus", "stage", "boundary", "method", "cells",
                                         "frequency_Hz", "angular_frequency_rad_per_s", "storage_modulus_Pa",
                                         "loss_modulus_Pa", "measured_storage_modulus_Pa", "measured_loss_modulus_Pa",
                                         "ratio", "storage_ratio", "loss_ratio", "phase_difference_deg", "error"));
  EXPECT_THAT(table.numbers("frequency_Hz")[1], testing::DoubleNear(1.0, 1e-15));
  EXPECT_THAT(table.numbers("ratio")[1], testing::DoubleNear(0.5, 1e-15));
  EXPECT_THAT(table.numbers("loss_ratio")[1], testing::DoubleNear(0.5, 1e-15));
  EXPECT_THAT(table.numbers("phase_difference_deg"),
              ElementsAre(testing::DoubleNear(45.0, 1e-12), testing::DoubleNear(0.0, 1e-12)));
  const auto read = read_comparisons(directory.path()).at("A");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].in_frequency[1].measured_loss, 8.0);
  EXPECT_EQ(read[0].in_frequency[1].error, 0.5);
  EXPECT_EQ(read[0].in_frequency[0].error, std::nullopt);
}

TEST(ReadComparisons, TakesATableOfAnEarlierVersionAsOfTheShearModulus) {
  const test::TemporaryDirectory directory;
  write_text(directory.path() / "comparison.csv",
             "measurement,stage,boundary,method,cells,time_s,modulus_Pa,measured_Pa,ratio\n"
             "rheometer,A,periodic,quasistatic,24,1,3,2,1.5\n");
  EXPECT_EQ(read_comparisons(directory.path()).at("A").front().kind, ModulusKind::shear);
  write_text(directory.path() / "comparison.csv",
             "measurement,modulus,stage,boundary,method,cells,time_s,modulus_Pa,measured_Pa,ratio\n"
             "rheometer,P-wave,A,periodic,quasistatic,24,1,3,2,1.5\n");
  EXPECT_THAT([&] { read_comparisons(directory.path()); },
              testing::ThrowsMessage<FileError>(testing::HasSubstr("expected shear, young or bulk, got \"P-wave\"")));
}

TEST(WriteComparisons, LeavesNoTableWithoutAMeasurement) {
  const test::TemporaryDirectory directory;
  write_comparisons(directory.path(), {{test::stage_with("A", {})}, {}});
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

}  // namespace
}  // namespace breccia
