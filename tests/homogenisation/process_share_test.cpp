#include "breccia/homogenisation/process_share.hpp"

#include <gtest/gtest.h>

#include "breccia/discretisation/phase.hpp"
#include "breccia/homogenisation/memory.hpp"
#include "breccia/homogenisation/quasistatic_time.hpp"

namespace breccia {
namespace {

/// A box of discs with a binder that does not relax, one elastic solution, as HB-1 of PBX-9501.
Study discs(int cells, double side) {
  Stage stage;
  stage.name = "HB-1";
  stage.matrix = Material{"binder", 1.48e3, PronySeries(3.6e9), PronySeries(1e6)};
  stage.side = side;
  stage.cells = cells;
  Filler filler;
  filler.material = {"hmx", 1.85e3, PronySeries(13.4e9), PronySeries(5.84e9)};
  filler.fraction = 0.65;
  filler.sizes = SingleSize{5e-6};
  stage.fillers = {filler};
  Study study;
  study.stages = {stage};
  study.tests.first_time = 1e-8;
  study.tests.last_time = 1e-4;
  study.tests.loads = {Load::shear};
  study.tests.field_times = {};
  return study;
}

TEST(ProcessShare, OfOneProcessIsTheWhole) {
  const auto study = discs(1000, 80e-6);
  const auto& stage = study.stages.front();
  const auto [bytes, seconds, common] = quasistatic_share(study, stage, Boundary::displacement, 1000, 1);
  EXPECT_DOUBLE_EQ(bytes + common, quasistatic_memory(study, stage, 1000));
  EXPECT_DOUBLE_EQ(common, 4e6 * sizeof(PhaseIndex));
  EXPECT_DOUBLE_EQ(seconds, quasistatic_time(study, stage, Boundary::displacement, 1000));
}

// The memory of docs/performance.md, "Several processes", without the 60 MB of the program.
TEST(ProcessShare, OfMemoryAgreesWithMeasuredRuns) {
  const auto study = discs(1000, 80e-6);
  const auto& stage = study.stages.front();
  for (const auto& [processes, bytes] :
       std::vector<std::pair<int, double>>{{1, 545e6}, {2, 287e6}, {4, 161e6}, {8, 93e6}, {16, 61e6}}) {
    const auto share = quasistatic_share(study, stage, Boundary::displacement, 1000, processes);
    EXPECT_GT(share.bytes + share.common_bytes, bytes / 1.5) << processes;
    EXPECT_LT(share.bytes + share.common_bytes, bytes * 1.5) << processes;
  }
}

TEST(ProcessShare, FallsWithTheNumberOfProcesses) {
  const auto study = discs(4000, 320e-6);
  const auto& stage = study.stages.front();
  auto last = quasistatic_share(study, stage, Boundary::periodic, 4000, 1);
  for (const int processes : {2, 4, 8, 16, 64, 128, 1024}) {
    const auto share = quasistatic_share(study, stage, Boundary::periodic, 4000, processes);
    EXPECT_LT(share.bytes, last.bytes) << processes;
    EXPECT_LT(share.seconds, last.seconds) << processes;
    last = share;
  }
  EXPECT_GT(last.seconds, quasistatic_time(study, stage, Boundary::periodic, 4000) / 1024) << "the coarse problem";
}

TEST(ProcessShare, OfADynamicTestHasALayerOfNodesMoreThanOfCells) {
  const auto [bytes, seconds, common] = dynamic_share(2, 999, 1e9, 100.0, 10);
  const double labels = 1998.0 * 1998.0 * sizeof(PhaseIndex), layer = 1000.0 * 5.0 * sizeof(double);
  EXPECT_DOUBLE_EQ(bytes, layer + (1e9 - labels - layer) / 10.0);
  EXPECT_DOUBLE_EQ(seconds, 10.0);
  EXPECT_DOUBLE_EQ(common, labels);
  const auto alone = dynamic_share(3, 50, 1e9, 100.0, 1);
  EXPECT_DOUBLE_EQ(alone.bytes + alone.common_bytes, 1e9);
}

}  // namespace
}  // namespace breccia
