#include "breccia/campaign/run.hpp"

#include <filesystem>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/deck/read_study.hpp"
#include "breccia/error.hpp"

#include "campaign/result_transaction.hpp"
#include "io/text_file.hpp"
#include "messages.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::HasSubstr;

/// A single coarse stage under one load and boundary.
Study small_study() {
  auto study = test::two_stages();
  study.stages = {test::four_discs("fine", test::binder, 6e-3, 8)};
  study.tests.boundaries = {Boundary::displacement};
  return study;
}

std::optional<double> taken_over(const Study& study, const std::filesystem::path& results) {
  return ResultTransaction(study, results, {}).take_over().seconds;
}

/// Results of another study are neither taken over nor replaced.
void expect_refusal(const Study& study, const std::filesystem::path& results) {
  EXPECT_EQ(taken_over(study, results), std::nullopt);
  for (const bool resume : {false, true}) {
    EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(run_study(study, results, {.resume = resume})); }),
                HasSubstr("not both are as a deck gives them"));
  }
}

TEST(RunStudy, AStudyPutTogetherInTheMemoryIsKnownByItsContent) {
  const test::TemporaryDirectory directory;
  const auto results = directory.path() / "results";
  static_cast<void>(run_study(small_study(), results));
  EXPECT_TRUE(taken_over(small_study(), results).has_value());
  auto other = small_study();
  other.stages[0].side *= 2.0;
  expect_refusal(other, results);
}

constexpr auto deck_of_a_box = R"(
[materials.binder]
density = "1 g/cm^3"
bulk = "1 GPa"
shear = { equilibrium = "0.01 MPa", terms = [{ time = "10 ms", modulus = "0.5 MPa" }] }
[[stages]]
name = "box"
matrix = "binder"
box = "6 mm"
cells = 8
[tests]
loads = ["shear"]
times = ["1 ms", "50 ms"]
boundaries = ["displacement"]
)";

// The hash of its deck does not identify a study that was changed since.
TEST(RunStudy, AStudyThatWasChangedAfterItsDeckWasReadIsAnotherOne) {
  const test::TemporaryDirectory directory;
  directory.write("deck.toml", deck_of_a_box);
  const auto results = directory.path() / "results", others = directory.path() / "others";
  auto study = read_study(directory.path() / "deck.toml");
  static_cast<void>(run_study(study, results));
  EXPECT_TRUE(taken_over(study, results).has_value());
  std::get<Material>(study.stages[0].matrix).shear = PronySeries(1e6);
  expect_refusal(study, results);

  static_cast<void>(run_study(study, others));
  EXPECT_TRUE(taken_over(study, others).has_value());
  const auto unchanged = read_study(directory.path() / "deck.toml");
  expect_refusal(unchanged, others);
}

TEST(RunStudy, RefusesToReplaceTheDeckOfAChangedStudy) {
  const test::TemporaryDirectory directory;
  directory.write("study.json", deck_of_a_box);
  auto study = read_study(directory.path() / "study.json");
  study.title = "changed";
  EXPECT_THROW(static_cast<void>(run_study(study, directory.path(), {.overwrite = true})), InputError);
  EXPECT_EQ(read_text(directory.path() / "study.json"), deck_of_a_box);
}

TEST(RunStudy, LeavesNothingBehindIfItFailsAtOnce) {
  auto study = test::two_stages();
  study.stages[0].fillers[0].sizes = SingleSize{1e-3};
  study.stages[0].fillers[0].fraction = 0.95;  // a fraction above that of the densest packing of equal discs
  study.stages[0].packing = LubachevskyStillingerPacking<2>{};
  const test::TemporaryDirectory directory;
  const auto results = directory.path() / "results";
  EXPECT_THROW(static_cast<void>(run_study(study, results)), Error);
  EXPECT_FALSE(std::filesystem::exists(results));
}

}  // namespace
}  // namespace breccia
