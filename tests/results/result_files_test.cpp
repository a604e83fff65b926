#include "results/result_files.hpp"

#include <filesystem>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/text_file.hpp"
#include "results/microstructure_files.hpp"
#include "tables/csv.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

TEST(ResultFiles, OfAStageAreKnownByTheirNames) {
  for (const auto* name : {"microstructure.csv", "microstructure.svg", "modulus.svg", "bulk_modulus.svg", "response.h5",
                           "labels.npy", "labels.vti", "shear-traction-dynamic-300-1.h5", "fields.vtkhdf",
                           "fields-2-stress.svg", "packing.checkpoint.h5"}) {
    EXPECT_TRUE(is_file_of_a_stage(name)) << name;
  }
  for (const auto* name : {"", "notes.txt", "study.json", "curves.csv", "microstructure.csv.bak", "fields.svg",
                           "my-fields.vtkhdf", "response.h5x", "fields/../../x.vtkhdf"}) {
    EXPECT_FALSE(is_file_of_a_stage(name)) << name;
  }
}

TEST(ResultFiles, InADirectoryAreThoseOfAStudyAndItsStagesOrOfASweep) {
  const test::TemporaryDirectory directory;
  for (const auto* stage : {"A", "B", "other"}) std::filesystem::create_directory(directory.path() / stage);
  for (const auto* name : {"study.json", "curves.csv", "report.html", "sweep.json", "notes.txt", "A/response.h5",
                           "A/notes.txt", "other/response.h5"}) {
    directory.write(name, "");
  }
  std::filesystem::create_directory(directory.path() / "B" / "modulus.svg");
  EXPECT_THAT(study_files_in(directory.path(), {"A", "B", "missing"}),
              UnorderedElementsAre("study.json", "curves.csv", "report.html", "A/response.h5"))
      << "a directory is no file";
  EXPECT_THAT(sweep_files_in(directory.path()), UnorderedElementsAre("report.html", "sweep.json"));
  EXPECT_THAT(study_files_in(directory.path() / "nowhere", {"A"}), IsEmpty());
  EXPECT_THAT(sweep_files_in(directory.path() / "nowhere"), IsEmpty());
}

TEST(MicrostructureFiles, TellEveryParticle) {
  const test::TemporaryDirectory directory;
  Stage stage;
  stage.name = "A";
  stage.side = 6e-3;
  stage.cells = 6;
  stage.fillers.resize(1);
  StageMicrostructure packed;
  Microstructure<2> discs = {
      6e-3, Walls::periodic, {{{1e-3, 2e-3 / 3.0}, 2e-3}, {{4e-3, std::numbers::pi * 1e-3}, 1e-3}}};
  packed.box = discs;
  write_microstructure(directory.path(), stage, packed);
  const auto table = read_csv(directory.path() / "microstructure.csv");
  EXPECT_THAT(table.names(), ElementsAre("x_m", "y_m", "diameter_m"));
  EXPECT_THAT(table.numbers("x_m"), ElementsAre(1e-3, 4e-3));
  EXPECT_THAT(table.numbers("y_m"), ElementsAre(2e-3 / 3.0, std::numbers::pi * 1e-3));
  EXPECT_THAT(table.numbers("diameter_m"), ElementsAre(2e-3, 1e-3));
  EXPECT_THAT(read_text(directory.path() / "microstructure.csv"),
              HasSubstr("# Particles of stage A in a box of 0.006 m"));
  EXPECT_THAT(read_text(directory.path() / "microstructure.svg"), HasSubstr("2 particles in a box of 6 mm"));
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "labels.npy"));
  EXPECT_THAT(read_text(directory.path() / "labels.vti"), HasSubstr("particle"));
  stage.fillers.resize(2);
  stage.fillers[0].material.name = "quartz";
  stage.fillers[1].material.name = "glass";
  discs.fillers = {1, 0};
  packed.box = discs;
  write_microstructure(directory.path(), stage, packed);
  const auto of_two = read_csv(directory.path() / "microstructure.csv");
  EXPECT_THAT(of_two.names(), ElementsAre("x_m", "y_m", "diameter_m", "filler"));
  EXPECT_THAT(of_two.numbers("filler"), ElementsAre(1.0, 0.0));
}

TEST(MicrostructureFiles, LeaveOutTheLabelsOfALargeGrid) {
  const test::TemporaryDirectory directory;
  const Stage stage = {.name = "A", .matrix = {}, .side = 1.0, .cells = 2049};
  StageMicrostructure empty;
  empty.box = Microstructure<2>{.side = 1.0, .particles = {}};
  write_microstructure(directory.path(), stage, empty);
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "labels.npy"));
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "labels.vti"));
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "microstructure.svg"));
}

}  // namespace
}  // namespace breccia
