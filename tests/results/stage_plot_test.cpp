#include "results/stage_plot.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/text_file.hpp"
#include "results/hand_made_results.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const Curve falling{{1e-3, 2e6}, {1e-2, 1e6}};

class StagePlot : public testing::Test {
 protected:
  StagePlot() { study.title = "two scales"; }

  /// The plot of the shear modulus of a stage with these tests, after those stages that are done before it.
  [[nodiscard]] std::string plot_of(const Stage& stage, std::vector<TestResult> tests,
                                    std::vector<StageResult> earlier = {}) const {
    earlier.push_back(test::stage_with(stage.name, std::move(tests)));
    write_plots(directory.path(), study, stage, {std::move(earlier), {}});
    const auto file = directory.path() / "modulus.svg";
    return std::filesystem::exists(file) ? read_text(file) : "";
  }

  test::TemporaryDirectory directory;
  Study study = test::two_stages();
};

TEST_F(StagePlot, NamesTheTestsTheMatrixAndWhatWasMeasured) {
  study.measurements = {{"Wetzel, 1999", "fine", PronySeries(1e6), {}},
                        {"of another stage", "coarse", PronySeries(1e6), {}},
                        {"at other times", "fine", PronySeries(1e6), TimeWindow{10.0, 20.0}}};
  const auto svg =
      plot_of(study.stages[0], {test::test_with({.grid = TestGrid(12)}, falling),
                                test::test_with({.boundary = Boundary::traction, .grid = TestGrid(12)}, falling),
                                test::test_with({.load = Load::diagonal_shear, .grid = TestGrid(12)}, falling)});
  EXPECT_THAT(svg,
              AllOf(HasSubstr(">two scales: fine<"), HasSubstr(">displacement<"), HasSubstr(">traction<"),
                    HasSubstr(">displacement, xx-yy<"), HasSubstr(">matrix<"), HasSubstr(">measured, Wetzel, 1999<")));
  EXPECT_THAT(svg, AllOf(Not(HasSubstr("of another stage")), Not(HasSubstr("at other times"))));
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "bulk_modulus.svg"));
}

TEST_F(StagePlot, ShowsTheMatrixThatAnEarlierStageHasMadeForEachBoundary) {
  auto fine = test::stage_with("fine", {});
  for (const auto boundary : study.tests.boundaries) {
    fine.materials.push_back({boundary, Method::quasistatic, {test::glass, {1e-3, 50e-3}, 0.0, 0.0}});
  }
  const auto svg = plot_of(study.stages[1], {test::test_with({.grid = TestGrid(12)}, falling)}, {fine});
  EXPECT_THAT(svg,
              AllOf(HasSubstr(">matrix, displacement<"), HasSubstr(">matrix, traction<"), Not(HasSubstr(">matrix<"))));
}

TEST_F(StagePlot, ShowsOfSeveralGridsTheLimitAlone) {
  study.stages[0].coarser_cells = {6};
  const auto on_coarse = test::test_with({.grid = TestGrid(6)}, falling);
  const auto on_fine = test::test_with({.grid = TestGrid(12)}, falling);
  const auto limit = test::test_with({.grid = TestGrid::extrapolated()}, {{1e-3, 1.5e6}, {1e-2, 0.5e6}});
  const auto of_limit = plot_of(study.stages[0], {limit});
  EXPECT_EQ(plot_of(study.stages[0], {on_coarse, on_fine, limit}), of_limit);
  EXPECT_NE(plot_of(study.stages[0], {on_fine}), of_limit);
}

TEST_F(StagePlot, NamesTheMethodsAndTheirTimeDomains) {
  study.tests.methods = {Method::quasistatic, Method::dynamic};
  auto dynamic = test::test_with({.method = Method::dynamic, .grid = TestGrid(12)}, falling);
  DynamicRecord record;
  for (const double factor : {1.0, 1030.0}) {
    auto& domain = record.domains.emplace_back();
    domain.mass_scaling = factor;
    domain.window = {1e-3, 1e-2};
  }
  dynamic.record = std::move(record);
  const auto svg = plot_of(study.stages[0], {test::test_with({.grid = TestGrid(12)}, falling), dynamic});
  EXPECT_THAT(svg, AllOf(HasSubstr(">displacement, quasistatic<"), HasSubstr(">displacement, dynamic<"),
                         HasSubstr(">density x 1<"), HasSubstr(">density x 1030<")));
}

TEST_F(StagePlot, HasTheBulkModulusInAFileOfItsOwn) {
  EXPECT_EQ(plot_of(study.stages[0], {test::test_with({.load = Load::bulk, .grid = TestGrid(12)}, falling)}), "");
  EXPECT_THAT(read_text(directory.path() / "bulk_modulus.svg"), HasSubstr("Plane-strain bulk modulus K(t) + G(t)/3"));
}

TEST_F(StagePlot, IsLeftOutWhereNothingCanBeDrawn) {
  EXPECT_EQ(plot_of(study.stages[0], {}), "");
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

}  // namespace
}  // namespace breccia
