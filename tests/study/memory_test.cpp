#include "breccia/study/memory.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"

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

TEST(Memory, IsWhatQuasiStaticRunsHaveTaken) {
  // HB-1 of PBX-9501 without fields (docs/performance.md).
  const auto small = study_of(256, {}), large = study_of(2000, {});
  EXPECT_NEAR(quasistatic_memory(small, small.stages.front(), 256), 0.26e9, 0.07e9) << "direct";
  EXPECT_NEAR(quasistatic_memory(large, large.stages.front(), 2000), 2.69e9, 0.1e9) << "substructures";
}

TEST(Memory, SomeIsLeft) {
  EXPECT_GT(available_memory(), 1e6);
}

TEST(Memory, TooLittleIsRefusedWithWhatWouldFit) {
  const auto study = study_of(2000, {Method::quasistatic, Method::dynamic});
  EXPECT_NO_THROW(require_memory(study, std::numeric_limits<double>::infinity()));
  const auto message = test::message_of<InputError>([&] { require_memory(study, 1e8); });
  EXPECT_THAT(message,
              testing::MatchesRegex("A: 2000 x 2000 cells take about 2.72 GB by the quasi-static method, and 0.1 GB "
                                    "are left; cells = 38[0-9] would fit .*\nA: 2000 x 2000 .* dynamic method.*"));
  EXPECT_THAT(test::message_of<InputError>([&] { require_memory(study, -1.0); }),
              testing::Not(testing::HasSubstr("would fit")));
}

}  // namespace
}  // namespace breccia
