#include "breccia/homogenisation/memory.hpp"

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/homogenisation/available_memory.hpp"

#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

Study study_of(int cells, std::vector<Method> methods) {
  Study study;
  Stage stage;
  stage.name = "A";
  stage.matrix = Material{"matrix", 1e3, PronySeries(1e9), PronySeries(1e5, {{1e-2, 1e6}, {1e-3, 1e6}})};
  stage.side = 1e-3;
  stage.cells = cells;
  study.stages = {stage};
  study.tests.first_time = 1e-3;
  study.tests.last_time = 1e-2;
  study.tests.methods = std::move(methods);
  return study;
}

TEST(Memory, AgreesWithThatOfMeasuredQuasiStaticRuns) {
  // HB-1 of PBX-9501 without fields (docs/performance.md).
  const auto small = study_of(256, {}), large = study_of(2000, {});
  EXPECT_NEAR(quasistatic_memory(small, small.stages.front(), 256), 0.26e9, 0.07e9) << "direct";
  EXPECT_NEAR(quasistatic_memory(large, large.stages.front(), 2000), 2.69e9, 0.1e9) << "substructures";
}

// Two nodal vectors of eight bytes for each of the two terms of the matrix and each load, of the fine run and the
// coarse.
TEST(Memory, OfSteppingGrowsWithTheTermsAndTheLoads) {
  auto study = study_of(100, {Method::quasistatic});
  study.tests.loads = {Load::shear, Load::diagonal_shear, Load::bulk};
  const auto& stage = study.stages.front();
  const double reduced = quasistatic_memory(study, stage, 100);
  study.tests.quasistatic.solver = Solver::stepping;
  const double stepping = quasistatic_memory(study, stage, 100);
  EXPECT_NEAR((stepping - reduced) / (2.0 * 100.0 * 100.0), 2.0 * 8.0 * 2.0 * 3.0, 1e-6);
  study.tests.loads.pop_back();
  EXPECT_NEAR((quasistatic_memory(study, stage, 100) - reduced) / (2.0 * 100.0 * 100.0), 2.0 * 8.0 * 2.0 * 2.0, 1e-6);
}

// Of substructures without fields 340 bytes an unknown are measured (docs/performance.md); fields take as much again.
TEST(Memory, OfFieldsIsThatOfTheSolutionOnceMore) {
  auto study = study_of(2000, {Method::quasistatic});
  const double without = quasistatic_memory(study, study.stages.front(), 2000);
  study.tests.field_times = {1e-2};
  EXPECT_NEAR(quasistatic_memory(study, study.stages.front(), 2000) / without, 2.0, 1e-12);
}

Study cube_of(double aspect) {
  auto study = study_of(64, {Method::quasistatic});
  auto& stage = study.stages.front();
  stage.packing = PackingMethod<3>();
  Filler filler;
  filler.material = {"filler", 1e3, PronySeries(1e10), PronySeries(1e10)};
  filler.fraction = 0.2;
  filler.sizes = SingleSize{1e-4};
  filler.shape = FillerShape{EllipticOutline{aspect}};
  stage.fillers = {filler};
  return study;
}

// 18 strains of a phase in 3/2 cells per h^2 of the interface, in each of three nodal vectors.
TEST(Memory, OfFlatEllipsoidsHasTheStrainsInTheirLargerInterface) {
  const auto spheres = cube_of(1.0), flat = cube_of(0.1);
  const double unknowns = 3.0 * 64 * 64 * 64, h = 1e-3 / 64;
  // An oblate ellipsoid of aspect c / a has the surface 2 pi a^2 (1 + (1 - e^2) / e artanh e), e^2 = 1 - (c / a)^2.
  const double e = std::sqrt(1.0 - 0.01), over_sphere = 0.5 * std::cbrt(100.0) * (1.0 + 0.01 / e * std::atanh(e));
  const double more = 3.0 * 8.0 * 18.0 / 3.0 * 1.5 * h * 0.2 * 6.0 / 1e-4 * (over_sphere - 1.0);
  EXPECT_NEAR(
      (quasistatic_memory(flat, flat.stages.front(), 64) - quasistatic_memory(spheres, spheres.stages.front(), 64)) /
          unknowns,
      more, 1e-9 * more);
}

TEST(Memory, IsLackingFromOneByteTooFewOn) {
  const auto study = study_of(100, {Method::quasistatic});
  const double bytes = quasistatic_memory(study, study.stages.front(), 100);
  EXPECT_THAT(lacking_memory(study, bytes), testing::IsEmpty());
  EXPECT_THAT(lacking_memory(study, bytes - 1.0), testing::ElementsAre(testing::HasSubstr("cells = 99 would fit")));
  EXPECT_THAT(lacking_memory(study, 1e-6 * bytes), testing::ElementsAre(testing::Not(testing::HasSubstr("would fit"))))
      << "no grid of a single cell";
}

// A fourth of the points take a fourth of the memory of an explicit run.
TEST(Memory, OfTheDynamicMethodGrowsWithThePoints) {
  const auto bytes_for = [](int cells) {
    const auto study = study_of(cells, {Method::dynamic});
    double too_little = 1.0, enough = 1e12;
    while (enough / too_little > 1.001) {
      const double middle = std::sqrt(too_little * enough);
      (lacking_memory(study, middle).empty() ? enough : too_little) = middle;
    }
    return enough;
  };
  EXPECT_NEAR(bytes_for(200) / bytes_for(100), 4.0, 0.4);
}

TEST(Memory, SomeIsLeft) {
  EXPECT_GT(available_memory(), 1e6);
}

/// Control groups as the kernel shows them.
class ControlGroups : public testing::Test {
 protected:
  void group(const std::string& path, const std::string& limit_file, const std::string& limit,
             const std::string& used_file, const std::string& used, const std::string& statistics) const {
    std::filesystem::create_directories(directory_.path() / path);
    directory_.write(path + "/" + limit_file, limit + "\n");
    directory_.write(path + "/" + used_file, used + "\n");
    directory_.write(path + "/memory.stat", statistics);
  }
  [[nodiscard]] double left(const std::string& membership) const {
    return left_in_control_groups(directory_.written("membership", membership), directory_.path());
  }

 private:
  test::TemporaryDirectory directory_;
};

TEST_F(ControlGroups, OfVersion2LeaveTheLeastOnTheWayUp) {
  group("job", "memory.max", "8000000000", "memory.current", "5000000000", "anon 1\ninactive_file 1000000000\n");
  group("job/step", "memory.max", "max", "memory.current", "1000", "inactive_file 0\n");
  group("job/step/task", "memory.max", "6000000000", "memory.current", "1000000000", "");
  EXPECT_EQ(left("0::/job/step/task\n"), 4e9);
  EXPECT_EQ(left("0::/job/step\n"), 4e9);
  EXPECT_EQ(left("0::/\n"), std::numeric_limits<double>::infinity());
}

TEST_F(ControlGroups, OfAContainerAreTheRoot) {
  group(".", "memory.max", "2000000000", "memory.current", "500000000", "inactive_file 100000000\n");
  EXPECT_EQ(left("0::/\n"), 1.6e9);
}

TEST_F(ControlGroups, OfVersion1AreFoundAmongTheOthers) {
  group("memory/job", "memory.limit_in_bytes", "3000000000", "memory.usage_in_bytes", "1000000000",
        "inactive_file 7\ntotal_inactive_file 500000000\n");
  EXPECT_EQ(left("9:name=systemd:/\n4:memory:/job\n0::/\n"), 2.5e9);
  EXPECT_EQ(left("4:memory:/elsewhere\nnonsense\n"), std::numeric_limits<double>::infinity());
}

TEST(Memory, TooLittleIsRefusedWithTheCellsThatWouldFit) {
  const auto large = study_of(2000, {Method::quasistatic}),
             small = study_of(100, {Method::quasistatic, Method::dynamic});
  EXPECT_NO_THROW(require_memory(small, std::numeric_limits<double>::infinity()));
  EXPECT_THAT(test::message_of<InputError>([&] { require_memory(large, 1e8); }),
              testing::MatchesRegex("A: 2000 x 2000 cells take about 2.72 GB by the quasi-static method, and 0.1 GB "
                                    "are left; cells = 38[0-9] would fit"));
  EXPECT_THAT(test::message_of<InputError>([&] { require_memory(small, 1e6); }),
              testing::MatchesRegex("A: 100 x 100 .* quasi-static method.*\nA: 100 x 100 .* dynamic method.*"));
  EXPECT_THAT(test::message_of<InputError>([&] { require_memory(small, -1.0); }),
              testing::Not(testing::HasSubstr("would fit")));
}

// A grid of 1.7e10 cells is in no memory: the plan of its time domains does without it.
TEST(Memory, OfTheDynamicMethodIsFoundWithoutItsGrid) {
  EXPECT_THAT(lacking_memory(study_of(1 << 17, {Method::dynamic}), 1e9),
              testing::ElementsAre(testing::HasSubstr("A: 131072 x 131072 cells take about ")));
}

// 18 numbers for each cell of a cube and term of the matrix, 7 for each node, and the phases of the points.
TEST(Memory, OfTheDynamicMethodInCubesIsThatOfItsHistories) {
  auto study = study_of(400, {Method::dynamic});
  study.stages.front().packing = PackingMethod<3>();
  EXPECT_THAT(lacking_memory(study, 1e9),
              testing::ElementsAre(testing::MatchesRegex("A: 400 x 400 x 400 cells take about 25.6 GB by the dynamic "
                                                         "method, and 1 GB are left; cells = 13[0-9] would fit")));
}

// Mass scaling factors that are never valid have no plan, and so no estimate.
TEST(Memory, WithoutAnEstimateNothingIsLacking) {
  auto study = study_of(100, {Method::dynamic});
  study.tests.dynamic.mass_scaling_factors = {1e12};
  EXPECT_THAT(lacking_memory(study, -1.0), testing::IsEmpty());
}

}  // namespace
}  // namespace breccia
