#include "results/provenance.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "one_vector_response.hpp"
#include "results/hand_made_results.hpp"
#include "results/study_document.hpp"
#include "study/identity.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using nlohmann::json;
using testing::DoubleNear;
using testing::MatchesRegex;

class WriteProvenance : public testing::Test {
 protected:
  WriteProvenance() {
    study.title = "two scales";
    study.provenance.deck = "deck.toml";
    study.provenance.deck_text = "title = \"two scales\"\n";
    study.provenance.overrides = {"stages.0.cells=12"};
    study.provenance.hash = "0123456789abcdef";
  }
  [[nodiscard]] json written(const StudyResult& result, const StageRecords& records = {}) const {
    auto as_read = study;
    as_read.provenance.content = content_of(study);
    write_provenance(directory.path(), as_read, result, records);
    const auto text = read_text(directory.path() / "study.json");
    write_study_document(directory.path(), read_study_document(directory.path()));
    EXPECT_EQ(read_text(directory.path() / "study.json"), text) << "what is written is read back";
    return json::parse(text);
  }
  /// The record of a test that is the only one of the first stage.
  [[nodiscard]] json written_of(const TestResult& test) const {
    return written({{test::stage_with("fine", {test})}, {}}).at("stages").at(0).at("tests").at(0);
  }

  test::TemporaryDirectory directory;
  Study study = test::two_stages();
};

TEST_F(WriteProvenance, TellsWhatWasAskedFor) {
  study.materials.at(0).shift = TemperatureShift{WilliamsLandelFerry{6.5, 120.0, 293.15}, 313.15};
  const auto record = written({});
  EXPECT_EQ(record.at("program"), "breccia");
  EXPECT_EQ(record.at("version"), BRECCIA_VERSION);
  EXPECT_EQ(record.at("title"), "two scales");
  EXPECT_EQ(record.at("deck"), "deck.toml");
  EXPECT_EQ(record.at("deck_text"), "title = \"two scales\"\n");
  EXPECT_EQ(record.at("overrides"), json({"stages.0.cells=12"}));
  EXPECT_EQ(record.at("hash"), "0123456789abcdef");
  EXPECT_EQ(record.at("times_s"), json({1e-3, 50e-3}));
  EXPECT_EQ(record.at("stage_names"), json({"fine", "coarse"}));
  EXPECT_EQ(record.at("materials"), json::parse(R"([
    {"name": "binder", "density_kg_per_m3": 1000.0, "bulk": {"equilibrium_Pa": 1e9, "terms": []},
     "shear": {"equilibrium_Pa": 1e4, "terms": [{"relaxation_time_s": 0.01, "modulus_Pa": 0.5e6}]},
     "temperature_shift": {"c1": 6.5, "c2_K": 120.0, "reference_K": 293.15, "temperature_K": 313.15}},
    {"name": "glass", "density_kg_per_m3": 2000.0, "bulk": {"equilibrium_Pa": 10e9, "terms": []},
     "shear": {"equilibrium_Pa": 5e9, "terms": []}}])"));
}

TEST_F(WriteProvenance, HasADateOnceAllIsDone) {
  const auto begun = written({});
  EXPECT_EQ(begun.at("complete"), false);
  EXPECT_TRUE(begun.at("date").is_null());
  EXPECT_TRUE(begun.at("wall_time_s").is_null());
  const auto done = written({{}, 2.5});
  EXPECT_EQ(done.at("complete"), true);
  EXPECT_EQ(done.at("wall_time_s"), 2.5);
  EXPECT_THAT(done.at("date").get<std::string>(), MatchesRegex("20..-..-..T..:..:..Z"));
}

TEST_F(WriteProvenance, TellsHowAReducedResponseWasMade) {
  auto test = test::test_with({Load::bulk, Boundary::traction, Method::quasistatic, TestGrid(12)}, {{1.0, 1.0}});
  test.error_estimate = 1e-6;
  test.seconds = 0.5;
  QuasistaticRecord record;
  record.reduced =
      test::one_vector_response(Load::bulk, Boundary::traction, {},
                                {{{{.bulk = 2.0, .shear = 1.0}}, 0.0}, {{{.bulk = 2.0, .shear = 0.5}}, 0.01}});
  record.effort = {.is_direct = false,
                   .unknowns = 288,
                   .factorisations = 2,
                   .solves = 5,
                   .iterations = 40,
                   .most_iterations = 12,
                   .largest_residual = 1e-9};
  test.record = std::move(record);
  study.tests.quasistatic.sampling.tolerance = 1e-4;
  EXPECT_EQ(written_of(test), json::parse(R"({
    "load": "bulk", "boundary": "traction", "method": "quasistatic", "cells": 12,
    "solver": "reduced", "volumetric": "averaged", "mixing": "series", "error_estimate": 1e-6, "wall_time_s": 0.5,
    "linear": {"method": "iterative", "unknowns": 288, "factorisations": 2, "solves": 5, "iterations": 40,
               "most_iterations": 12, "largest_residual": 1e-9},
    "tolerance": 1e-4, "range": "matrix",
    "snapshots": [{"shear_Pa": 1.0, "bulk_Pa": 2.0, "error_before": null},
                  {"shear_Pa": 0.5, "bulk_Pa": 2.0, "error_before": 0.01}]})"));
}

TEST_F(WriteProvenance, TellsHowAnExtrapolationWasMade) {
  auto test = test::test_with({.grid = TestGrid::extrapolated()}, {{1.0, 1.0}});
  test.record = ExtrapolationRecord{{12, 24}};
  EXPECT_EQ(written_of(test), json::parse(R"({"load": "shear", "boundary": "displacement", "method": "quasistatic",
                                              "cells": "extrapolated", "from_cells": [12, 24]})"));
}

// 24 x 24 cells have 2304 points; 1000 steps in 2 s are 1.152 million points x steps/s.
TEST_F(WriteProvenance, TellsTheTimeDomainsOfADynamicTest) {
  auto test = test::test_with({.method = Method::dynamic, .grid = TestGrid(24)}, {{1.0, 1.0}});
  DynamicRecord record;
  auto& domain = record.domains.emplace_back();
  domain.mass_scaling = 1e4;
  domain.steps = 1000;
  domain.seconds = 2.0;
  domain.window = {1e-5, 1e-3};
  record.overlaps = {{{1e-4, 1e-3}, 0.02}};
  test.record = std::move(record);
  const auto found = written_of(test);
  EXPECT_EQ(found.at("time_domains").at(0).at("density_factor"), 1e4);
  EXPECT_EQ(found.at("time_domains").at(0).at("valid_s"), json({1e-5, 1e-3}));
  EXPECT_EQ(found.at("time_domains").at(0).at("points_x_steps_per_s"), 1.152e6);
  EXPECT_EQ(found.at("overlaps"), json::parse(R"([{"window_s": [1e-4, 1e-3], "mismatch": 0.02}])"));
  EXPECT_FALSE(found.contains("fit_error")) << "a relaxation test needs no fit";
}

TEST_F(WriteProvenance, TellsTheFilesOfFieldsAndWhoHasAnswered) {
  const auto tested = test::test_with({.grid = TestGrid(12)}, {{1.0, 1.0}});
  const StudyResult result{{test::stage_with("fine", {tested}), test::stage_with("coarse", {tested})}, {}};
  StageRecords records;
  records["fine"] = {{{tested.id, {{10e-3, "fields.vtkhdf", "fields-stress.svg", "fields-strain.svg"}}}}, "seed-1"};
  const auto stages = written(result, records).at("stages");
  EXPECT_EQ(stages.at(0).at("tests").at(0).at("fields"),
            json::parse(R"([{"time_s": 0.01, "file": "fields.vtkhdf", "stress_picture": "fields-stress.svg",
                             "strain_picture": "fields-strain.svg"}])"));
  EXPECT_EQ(stages.at(0).at("answered_from"), "seed-1");
  EXPECT_FALSE(stages.at(1).at("tests").at(0).contains("fields"));
  EXPECT_FALSE(stages.at(1).contains("answered_from"));
}

// The study has the hash of its content, and no deck.
TEST_F(WriteProvenance, OfAStudyThatWasChangedIsItsOwn) {
  write_provenance(directory.path(), study, {});
  std::ifstream file(directory.path() / "study.json");
  const auto record = json::parse(file);
  EXPECT_EQ(record.at("hash"), content_of(study));
  EXPECT_EQ(record.at("deck_text"), "");
}

TEST_F(WriteProvenance, TellsThePackingOfAStage) {
  auto stage = test::stage_with("fine", {});
  auto& packed = stage.microstructure;
  packed.box = Microstructure<2>{6e-3, Walls::hard, {{{1e-3, 1e-3}, 2e-3}, {{4e-3, 4e-3}, 1e-3}}};
  packed.fraction = 0.25;
  packed.interface_per_area = 300.0;
  packed.gap = 1e-3;  // in a box of 6 mm with 12 cells
  packed.wall_gap = std::numeric_limits<double>::infinity();
  packed.events = 99;
  packed.fillers = {{.particles = 2, .fraction = 0.25, .size_deviation = 0.01}};
  const auto regular = written({{stage}, {}}).at("stages").at(0).at("microstructure");
  EXPECT_EQ(regular.at("particles"), 2);
  EXPECT_EQ(regular.at("fraction"), 0.25);
  EXPECT_EQ(regular.at("interface_per_area_1_per_m"), 300.0);
  EXPECT_THAT(regular.at("smallest_gap_cells").get<double>(), DoubleNear(2.0, 1e-12));
  EXPECT_TRUE(regular.at("smallest_wall_gap_m").is_null()) << "JSON has no infinity";
  EXPECT_EQ(regular.at("smallest_diameter_m"), 1e-3);
  EXPECT_EQ(regular.at("largest_diameter_m"), 2e-3);
  EXPECT_EQ(regular.at("size_distribution_deviation"), 0.01);
  EXPECT_FALSE(regular.contains("seed"));
  study.stages[0].packing = LubachevskyStillingerPacking<2>{Walls::hard, 7};
  const auto random = written({{stage}, {}}).at("stages").at(0).at("microstructure");
  EXPECT_EQ(random.at("seed"), 7);
  EXPECT_EQ(random.at("events"), 99);
}

// The filler is a quarter of the first box, which is half of the second one: 0.5 + 0.5 * 0.25 by volume. By mass 2000 *
// 0.625 of 2000 * 0.625 + 1000 * 0.375.
TEST_F(WriteProvenance, TellsTheFillerOfTheWhole) {
  auto fine = test::stage_with("fine", {}), coarse = test::stage_with("coarse", {});
  fine.microstructure.fillers = {{.fraction = 0.25}};
  coarse.microstructure.fillers = {{.fraction = 0.5}};
  const auto stages = written({{fine, coarse}, {}}).at("stages");
  EXPECT_EQ(stages.at(0).at("filler_of_the_whole").at("fraction"), 0.25);
  const auto whole = stages.at(1).at("filler_of_the_whole");
  EXPECT_EQ(whole.at("fraction"), 0.625);
  EXPECT_THAT(whole.at("mass_fraction").get<double>(), DoubleNear(1250.0 / 1625.0, 1e-15));
  EXPECT_EQ(whole.at("materials").at(0).at("material"), "glass");
}

TEST_F(WriteProvenance, TellsTheBestAndTheWorstOfAComparison) {
  auto stage = test::stage_with("fine", {});
  stage.comparisons = {{"rheometer", {.grid = TestGrid(12)}, {{1.0, 3.0, 1.0}, {2.0, 0.9, 1.0}, {4.0, 0.25, 1.0}}}};
  const auto comparison = written({{stage}, {}}).at("stages").at(0).at("comparisons").at(0);
  EXPECT_EQ(comparison.at("measurement"), "rheometer");
  EXPECT_EQ(comparison.at("best"), json::parse(R"({"time_s": 2.0, "ratio": 0.9})"));
  EXPECT_EQ(comparison.at("worst"), json::parse(R"({"time_s": 4.0, "ratio": 0.25})"))
      << "a fourth is further than three";
}

TEST_F(WriteProvenance, StandsTextThatIsNoUtf8) {
  study.title = "caf\xe9";
  EXPECT_EQ(written({}).at("title"), "caf\xef\xbf\xbd");
}

TEST_F(WriteProvenance, FailsWhereThereIsNoDirectory) {
  EXPECT_THROW(write_provenance(directory.path() / "nowhere", study, {}), FileError);
}

}  // namespace
}  // namespace breccia
