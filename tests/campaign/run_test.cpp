#include "breccia/campaign/run.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "messages.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

// The results of studies without a hash could not be distinguished on the disk.
TEST(RunStudy, RefusesAStudyWithoutAHash) {
  const test::TemporaryDirectory directory;
  const auto results = directory.path() / "results";
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(run_study(test::two_stages(), results)); }),
              HasSubstr("this study has no provenance"));
  EXPECT_FALSE(std::filesystem::exists(results));
}

TEST(RunStudy, LeavesNothingBehindIfItFailsAtOnce) {
  auto study = test::two_stages();
  study.provenance.hash = "0123456789abcdef";
  study.stages[0].filler->sizes = SingleSize{1e-3};
  study.stages[0].filler->fraction = 0.95;  // denser than equal discs can be
  study.stages[0].filler->packing = LubachevskyStillingerPacking{};
  const test::TemporaryDirectory directory;
  const auto results = directory.path() / "results";
  EXPECT_THROW(static_cast<void>(run_study(study, results)), Error);
  EXPECT_FALSE(std::filesystem::exists(results));
}

}  // namespace
}  // namespace breccia
