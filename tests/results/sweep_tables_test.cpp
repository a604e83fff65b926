#include "results/sweep_tables.hpp"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "page/sweep_report.hpp"
#include "results/hand_made_sweep.hpp"
#include "results/sweep_plot.hpp"
#include "tables/csv.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using nlohmann::json;
using test::done_with;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> text_columns{
    "task", "stages.*.packing.seed", "stages.*.filler.gap", "stage", "load", "boundary", "method", "cells", "error"};

class SweepTables : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return directory.path() / name; }
  void write_record() const {
    write_sweep_record(directory.path(), sweep, result, std::vector<std::vector<std::string>>(result.size()));
  }

  test::TemporaryDirectory directory;
  Sweep sweep = test::seeds_and_gaps();
  SweepResult result = SweepResult(6);
};

TEST_F(SweepTables, HoldTheCurvesOfAllTasksThatAreDone) {
  result[1] =
      done_with({{1e-3, 1.0 / 3.0}, {1.0, 0.1}}, {Load::bulk, Boundary::traction, Method::dynamic, TestGrid(24)});
  result[1].curves[0].errors = {0.02, std::nullopt};
  result[4] = done_with({{1.0, 7.0}});
  write_sweep_tables(directory.path(), sweep, result);
  const auto table = read_csv(file("sweep.csv"), text_columns);
  EXPECT_THAT(table.names(), ElementsAre("task", "stages.*.packing.seed", "stages.*.filler.gap", "stage", "load",
                                         "boundary", "method", "cells", "time_s", "modulus_Pa", "error"));
  EXPECT_THAT(table.text("task"), ElementsAre("seed-1_gap-2 um", "seed-1_gap-2 um", "seed-3_gap-1 um"));
  EXPECT_THAT(table.text("stages.*.packing.seed"), ElementsAre("1", "1", "3"));
  EXPECT_THAT(table.text("stages.*.filler.gap"), ElementsAre("2 um", "2 um", "1 um"));
  EXPECT_THAT(table.text("load"), ElementsAre("bulk", "bulk", "shear"));
  EXPECT_THAT(table.text("boundary"), ElementsAre("traction", "traction", "displacement"));
  EXPECT_THAT(table.text("method"), ElementsAre("dynamic", "dynamic", "quasistatic"));
  EXPECT_THAT(table.text("cells"), ElementsAre("24", "24", "12"));
  EXPECT_THAT(table.numbers("time_s"), ElementsAre(1e-3, 1.0, 1.0));
  EXPECT_THAT(table.numbers("modulus_Pa"), ElementsAre(1.0 / 3.0, 0.1, 7.0));
  EXPECT_THAT(table.text("error"), ElementsAre("0.02", "", ""));
}

TEST_F(SweepTables, HoldTheSpreadOverTheSeeds) {
  for (const std::size_t task : {0U, 2U}) result[task] = done_with({{1.0, 1.0 + static_cast<double>(task)}});
  write_sweep_tables(directory.path(), sweep, result);
  const auto table = read_csv(file("spread.csv"), text_columns);
  EXPECT_THAT(table.names(),
              ElementsAre("stages.*.filler.gap", "stage", "load", "boundary", "method", "cells", "time_s", "tasks",
                          "mean_modulus_Pa", "standard_deviation_Pa", "smallest_Pa", "largest_Pa"));
  EXPECT_THAT(table.text("stages.*.filler.gap"), ElementsAre("1 um"));
  EXPECT_THAT(table.numbers("tasks"), ElementsAre(2.0));
  EXPECT_THAT(table.numbers("mean_modulus_Pa"), ElementsAre(2.0));
  EXPECT_THAT(table.numbers("standard_deviation_Pa"), ElementsAre(std::sqrt(2.0)));
  EXPECT_THAT(table.numbers("smallest_Pa"), ElementsAre(1.0));
  EXPECT_THAT(table.numbers("largest_Pa"), ElementsAre(3.0));
}

// A sweep that begins anew must not keep the numbers of the earlier sweep.
TEST_F(SweepTables, AreRemovedWhereTheyWouldHaveNoRows) {
  for (const auto* name : {"sweep.csv", "spread.csv", "sweep.svg"}) directory.write(name, "of an earlier sweep");
  write_sweep_tables(directory.path(), sweep, result);
  write_sweep_plot(directory.path(), sweep, result);
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST_F(SweepTables, TellTheStateOfEachTask) {
  sweep.tasks.resize(3);
  result = {done_with({{1.0, 1.0}}), {.state = TaskState::failed, .error = "jammed"}, {}};
  write_sweep_record(directory.path(), sweep, result, {{"aa"}, {"bb"}, {"cc", "dd"}});
  const auto record = json::parse(read_text(file("sweep.json")));
  EXPECT_EQ(record.at("program"), "breccia");
  EXPECT_EQ(record.at("version"), BRECCIA_VERSION);
  EXPECT_EQ(record.at("title"), "seeds and gaps");
  EXPECT_EQ(record.at("keys"), json({"stages.*.packing.seed", "stages.*.filler.gap"}));
  EXPECT_EQ(record.at("quantities"),
            json::parse(R"({"stages.*.filler.gap": {"unit": "um", "numbers": [1.0, 2.0, 1.0]}})"));
  EXPECT_EQ(record.at("tasks"), json::parse(R"([
    {"name": "seed-1_gap-1 um", "values": {"stages.*.packing.seed": 1, "stages.*.filler.gap": "1 um"},
     "hash": "hash of seed-1_gap-1 um", "state": "done", "wall_time_s": 2.0},
    {"name": "seed-1_gap-2 um", "values": {"stages.*.packing.seed": 1, "stages.*.filler.gap": "2 um"},
     "hash": "hash of seed-1_gap-2 um", "state": "failed", "wall_time_s": null, "error": "jammed", "may_replace": ["bb"]},
    {"name": "seed-2_gap-1 um", "values": {"stages.*.packing.seed": 2, "stages.*.filler.gap": "1 um"},
     "hash": "hash of seed-2_gap-1 um", "state": "waiting", "wall_time_s": null, "may_replace": ["cc", "dd"]}])"))
      << "what is done replaces nothing any more";
}

TEST_F(SweepTables, ShowATaskInAColourOfItsOwn) {
  sweep.tasks.resize(2);
  result = {done_with({{1.0, 1e6}, {2.0, 9e5}}), done_with({{1.0, 2e6}, {2.0, 1e6}})};
  write_sweep_plot(directory.path(), sweep, result);
  EXPECT_THAT(read_text(file("sweep.svg")), AllOf(HasSubstr(">seeds and gaps: A<"), HasSubstr(">seed-1_gap-1 um<"),
                                                  HasSubstr(">seed-1_gap-2 um<"), Not(HasSubstr("traction"))));
  result[1] = done_with({{1.0, 2e6}, {2.0, 1e6}}, {.boundary = Boundary::traction, .grid = TestGrid(12)});
  write_sweep_plot(directory.path(), sweep, result);
  EXPECT_THAT(read_text(file("sweep.svg")), HasSubstr(">seeds and gaps: A, traction dashed<"));
}

// The palette has seven colours.
TEST_F(SweepTables, ShowManyTasksInTheColoursOfTheirOtherKeys) {
  for (const auto* gap : {"1 um", "2 um"}) sweep.tasks.push_back(test::task_with(4, gap));
  result = SweepResult(8, done_with({{1.0, 1e6}, {2.0, 9e5}}));
  write_sweep_plot(directory.path(), sweep, result);
  EXPECT_THAT(read_text(file("sweep.svg")),
              AllOf(HasSubstr(">gap-1 um<"), HasSubstr(">gap-2 um<"), Not(HasSubstr("seed-"))));
}

TEST_F(SweepTables, HaveTheOverridesOfAllTasksInTheirRecord) {
  sweep.overrides = {"tests.points_per_decade=5"};
  sweep.tasks[0].study.provenance.overrides = {"tests.points_per_decade=5", "stages.*.packing.seed=1"};
  write_record();
  EXPECT_EQ(json::parse(read_text(file("sweep.json"))).at("overrides"), json({"tests.points_per_decade=5"}));
}

TEST_F(SweepTables, GiveThePageItsCurves) {
  result[2] = done_with({{1e-3, 1.0 / 3.0}, {1.0, 0.1}});
  write_record();
  write_sweep_report(directory.path(), result);
  const auto in_memory = read_text(file("report.html"));
  EXPECT_THAT(in_memory, HasSubstr("seeds and gaps"));
  const auto task = directory.path() / sweep.tasks[2].name;
  std::filesystem::create_directory(task);
  write_text(task / "curves.csv",
             "stage,load,boundary,method,cells,time_s,modulus_Pa\n"
             "A,shear,displacement,quasistatic,12,0.001,0.3333333333333333\n"
             "A,shear,displacement,quasistatic,12,1,0.1\n");
  const auto page = json::parse(sweep_page_data(directory.path()).json);
  EXPECT_EQ(page.at("curves"), json::parse(R"([{"task": 2, "stage": "A", "load": "shear", "boundary": "displacement",
                               "method": "quasistatic", "cells": "12", "time_s": [1e-3, 1.0],
                               "modulus_Pa": [0.333333, 0.1], "error": []}])"));
  EXPECT_EQ(page.at("sweep").at("tasks").size(), 6U);
  write_sweep_report(directory.path());
  EXPECT_EQ(read_text(file("report.html")), in_memory) << "the same page from the disk";
}

TEST_F(SweepTables, AreRefusedWithoutTheResultsOfATaskThatIsDone) {
  result[2] = done_with({{1.0, 0.1}});
  write_record();
  EXPECT_THAT(test::message_of<FileError>([&] { write_sweep_report(directory.path()); }),
              HasSubstr("curves.csv: cannot"));
  directory.write("sweep.json", R"({"title": "", "keys": [], "tasks": 7})");
  EXPECT_THAT(test::message_of<FileError>([&] { write_sweep_report(directory.path()); }),
              HasSubstr("sweep.json: not as `breccia run` writes it"));
}

}  // namespace
}  // namespace breccia
