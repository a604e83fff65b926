#include "campaign/sweep.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/deck/read_sweep.hpp"
#include "breccia/error.hpp"

#include "messages.hpp"
#include "tables/csv.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::Each;
using testing::IsEmpty;
using testing::Not;

constexpr auto deck = R"(
[materials.binder]
density = "1 g/cm^3"
bulk = "1 GPa"
shear = { equilibrium = "0.01 MPa", terms = [{ time = "10 ms", modulus = "0.5 MPa" }] }
temperature_shift = { law = "wlf", c1 = 6.5, c2 = "120 K", reference = "20 degC", temperature = "20 degC" }
[materials.glass]
density = "2 g/cm^3"
bulk = "10 GPa"
shear = "5 GPa"
[[stages]]
name = "fine"
matrix = "binder"
box = "6 mm"
cells = 12
filler = { material = "glass", sizes = { diameter = "2 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }
[[stages]]
name = "coarse"
matrix = "fine"
box = "60 mm"
cells = 12
filler = { material = "glass", sizes = { diameter = "20 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }
[tests]
loads = ["shear"]
times = ["1 ms", "50 ms"]
[[measurements]]
name = "rheometer"
stage = "fine"
shear = { curve = "measured.csv" }
)";

class SweepRun : public testing::Test {
 protected:
  SweepRun() {
    directory.write("deck.toml", deck);
    directory.write("measured.csv", "time_s,shear_modulus_Pa\n0.0005,1e6\n0.1,1e5\n");
  }
  /// Runs a sweep over one key, and returns for each task the stages in its table of comparisons.
  [[nodiscard]] std::vector<std::vector<std::string>> compared_stages(const std::string& key) const {
    const auto sweep = read_sweep(directory.path() / "deck.toml", {}, {key});
    const auto results = directory.path() / "results";
    static_cast<void>(run_sweep(sweep, results, {}));
    std::vector<std::vector<std::string>> stages;
    for (const auto& task : sweep.tasks) {
      const auto table = read_csv(results / task.name / "comparison.csv",
                                  {"measurement", "modulus", "stage", "boundary", "method", "cells", "error"});
      stages.push_back(table.text("stage"));
    }
    return stages;
  }

  test::TemporaryDirectory directory;
};

// The second task takes the stages over from the first one; the measurement is of another stage there.
TEST_F(SweepRun, StagesThatAreTakenOverAreComparedWithTheMeasurementsOfTheTask) {
  const auto stages = compared_stages(R"(measurements.0.stage=["fine", "coarse"])");
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_THAT(stages[0], AllOf(Not(IsEmpty()), Each("fine")));
  EXPECT_THAT(stages[1], AllOf(Not(IsEmpty()), Each("coarse")));
}

// The second task is computed from the reduced responses of the first one.
TEST_F(SweepRun, StagesAtAnotherTemperatureAreComparedWithTheMeasurement) {
  const auto stages = compared_stages(R"(materials.binder.temperature_shift.temperature=["20 degC", "40 degC"])");
  ASSERT_EQ(stages.size(), 2U);
  for (const auto& of_task : stages) EXPECT_THAT(of_task, AllOf(Not(IsEmpty()), Each("fine")));
}

// Its name and its hash would be those of another study.
TEST_F(SweepRun, ATaskThatWasChangedAfterItsDeckWasReadIsRefused) {
  auto sweep = read_sweep(directory.path() / "deck.toml", {}, {"stages.0.cells=[8, 12]"});
  sweep.tasks[1].study.tests.last_time *= 2.0;
  const auto results = directory.path() / "results";
  EXPECT_EQ(test::message_of<InputError>([&] { static_cast<void>(run_sweep(sweep, results, {})); }),
            "cells-12: this study of a sweep was changed after its deck was read; sweep a key of the deck, or run the "
            "study alone");
}

}  // namespace
}  // namespace breccia
