#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "good_deck.hpp"
#include "io/hdf5.hpp"
#include "messages.hpp"
#include "model_deck.hpp"
#include "study_directory.hpp"

namespace breccia {
namespace {

using test::StudyDirectory;

class Interruption : public testing::TestWithParam<int> {};

TEST_P(Interruption, KeepsFinishedTimeDomains) {
  // An elastic box: the second time domain would go on for days.
  auto deck = test::replaced(std::string(test::homogeneous_deck),
                             R"({ terms = [{ time = "10 ms", modulus = "0.5 MPa" }] })", R"("0.5 MPa")");
  deck = test::replaced(deck, "50 ms", "5000 s") + "[tests.dynamic]\nmass_scaling_factors = [0.1, 1]\n";
  const StudyDirectory study(deck);
  test::RunningCommand run(study.path(), StudyDirectory::arguments("run"));
  const auto finished = study.result("A/shear-displacement-dynamic-24-1.h5");
  ASSERT_TRUE(run.reaches([&] { return std::filesystem::exists(finished); })) << run.wait().errors;
  run.send(GetParam());
  const auto outcome = run.wait();
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.errors, "interrupted; the state is saved, and --resume continues from it\n");
  EXPECT_THAT(study.results(),
              testing::ElementsAre("A/labels.npy", "A/labels.vti", "A/microstructure.csv", "A/microstructure.svg",
                                   "A/packing.checkpoint.h5", "A/shear-displacement-dynamic-24-1.h5",
                                   "A/shear-displacement-dynamic-24.checkpoint.h5", "study.json"));
  EXPECT_EQ(Hdf5Reader(finished).attribute<double>("/history", "density_factor"), 0.1);
}

TEST_P(Interruption, KeepsAPackingOnItsWay) {
  // There are so many particles that packing takes a while.
  const StudyDirectory study(test::replaced(std::string(test::good_deck), "\"1 mm\"", "\"20 um\""));
  test::RunningCommand pack(study.path(), StudyDirectory::arguments("pack", {"--set", "stages.A.filler.gap=0 m"}));
  ASSERT_TRUE(pack.reaches([&] { return std::filesystem::exists(study.path() / "out"); })) << pack.wait().errors;
  pack.send(GetParam());
  const auto outcome = pack.wait();
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.errors, "interrupted; the state is saved, and --resume continues from it\n");
  EXPECT_THAT(study.results(), testing::ElementsAre("A/packing.checkpoint.h5", "study.json"));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interruption, testing::Values(SIGINT, SIGTERM), [](const auto& chosen) {
  return std::string(chosen.param == SIGINT ? "Interrupt" : "Terminate");
});

}  // namespace
}  // namespace breccia
