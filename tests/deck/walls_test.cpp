#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr auto times_of_tests = "times = [\"10 ns\", \"10 ms\"]\n";

class DeckWalls : public testing::Test {
 protected:
  test::DeckDirectory directory;
};

TEST_F(DeckWalls, ARandomPackingIsPeriodicUnlessABoundaryWouldCutIt) {
  const auto walls_of = [&](const std::string& packing, std::string_view boundaries) {
    const auto stage = test::replaced(std::string(test::stage), "{ method = \"lubachevsky-stillinger\" }", packing);
    const auto study = directory.study(test::join(test::materials, stage, "[tests]\n", times_of_tests, boundaries));
    return study.stages.at(0).packed_by<LubachevskyStillingerPacking<2>>()->walls;
  };
  const std::string without = R"({ method = "lubachevsky-stillinger", seed = 2 })",
                    with = R"({ method = "lubachevsky-stillinger", walls = true })",
                    periodic = R"({ method = "lubachevsky-stillinger", walls = false })";
  EXPECT_EQ(walls_of(without, ""), Walls::periodic);
  EXPECT_EQ(walls_of(without, R"(boundaries = ["periodic"])"), Walls::periodic);
  EXPECT_EQ(walls_of(without, R"(boundaries = ["displacement"])"), Walls::hard);
  EXPECT_EQ(walls_of(without, R"(boundaries = ["traction"])"), Walls::hard);
  EXPECT_EQ(walls_of(without, R"(boundaries = ["periodic", "traction"])"), Walls::periodic)
      << "all moduli are those of one box";
  EXPECT_EQ(walls_of(with, R"(boundaries = ["periodic"])"), Walls::hard);
  EXPECT_EQ(walls_of(periodic, R"(boundaries = ["displacement"])"), Walls::periodic);
}

TEST_F(DeckWalls, ParticlesThatTheSidesCutHaveBothBounds) {
  const auto deck_of = [](std::string_view walls) {
    return test::join(test::materials, R"(
[[stages]]
name = "A"
matrix = "binder"
box = "1 mm"
cells = 10
filler = { material = "hmx", fraction = 0.1, sizes = { diameter = "0.2 mm" } }
packing = { method = "lubachevsky-stillinger", walls = )",
                      walls, " }\n[tests]\n", times_of_tests);
  };
  const auto study = directory.study(deck_of("\"cut\""));
  EXPECT_TRUE(study.stages.front().is_periodic()) << "a window in a larger body";
  EXPECT_THAT(study.tests.boundaries, ElementsAre(Boundary::displacement, Boundary::traction));
  const auto named = directory.study(deck_of("\"cut\"") + "boundaries = [\"periodic\", \"traction\"]\n");
  EXPECT_THAT(named.tests.boundaries, ElementsAre(Boundary::periodic, Boundary::traction));
  EXPECT_THAT(directory.mistakes(deck_of("\"cut\"") + "boundaries = [\"periodic\"]\n"),
              HasSubstr("tests.boundaries: packing.walls = \"cut\" is a window: expected"));
  EXPECT_THAT(directory.mistakes(deck_of("\"cutt\"")), HasSubstr("packing.walls: expected \"cut\""));
}

TEST_F(DeckWalls, ARandomPackingSuitsTheShapes) {
  const auto stage_of = [&](std::string_view shape) {
    return directory
        .study(test::join(test::materials, R"(
[[stages]]
name = "A"
matrix = "binder"
box = "1 mm"
cells = 10
filler = { material = "hmx", fraction = 0.1, sizes = { diameter = "0.2 mm" })",
                          shape, R"( }
packing = { method = "random", seed = 7 }
[tests]
)",
                          times_of_tests))
        .stages.front();
  };
  EXPECT_EQ(stage_of("").packing_name(), PackingName::lubachevsky_stillinger);
  EXPECT_EQ(stage_of(", shape = { aspect = 2.0 }").packing_name(), PackingName::random_sequential);
  EXPECT_EQ(stage_of("").seed(), 7U);
}

}  // namespace
}  // namespace breccia
