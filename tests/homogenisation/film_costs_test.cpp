#include "homogenisation/plan/film_costs.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/homogenisation/plan.hpp"

#include "messages.hpp"

namespace breccia {
namespace {

/// Equal grains of 0.1 mm that fill 93.7 % of a box of this side [m], whole curve under both shears without fields.
Study study_of_grains(double side) {
  Study study;
  Filler filler;
  filler.material = {"hmx", 1.85e3, PronySeries(13.4e9), PronySeries(5.84e9)};
  filler.fraction = 0.937;
  filler.sizes = SingleSize{1e-4};
  Stage stage;
  stage.name = "grains";
  stage.matrix = Material{"binder", 1.48e3, PronySeries(3.6e9), PronySeries(0.0, {{1e-3, 1e6}, {1e-9, 1e9}})};
  stage.side = side;
  stage.fillers = {filler};
  stage.packing = LaguerrePacking<2>{};
  study.stages = {stage};
  study.tests.model = Model::films;
  study.tests.boundaries = {Boundary::periodic};
  study.tests.loads = {Load::shear, Load::diagonal_shear};
  study.tests.first_time = 1e-8;
  study.tests.last_time = 1e-2;
  return study;
}

/// The measured costs of runs of examples/pbx9501-films.toml (docs/performance.md, "Grains and films").
struct MeasuredFilms {
  double side;  ///< side of the box [m]
  std::optional<int> layers;
  double unknowns, bytes;
};

const std::vector<MeasuredFilms> measured_films = {
    {0.443e-3, {}, 4871, 68e6}, {0.443e-3, 4, 96627, 299e6}, {8.854e-3, {}, 1938127, 3140e6}};

// Runs are refused by this estimate, so that it must not be less than the measured memory, apart from a few per cent.
TEST(FilmCosts, AreNotLessThanThoseOfMeasuredRuns) {
  for (const auto& [side, layers, unknowns, bytes] : measured_films) {
    auto study = study_of_grains(side);
    study.tests.films.layers = layers;
    const auto grains = expected_grains(study.stages.front());
    EXPECT_GT(film_unknowns(study.tests, grains), 0.9 * unknowns) << side;
    EXPECT_GT(film_memory(study, study.stages.front(), grains), 0.95 * bytes) << side;
  }
}

/// Five solutions of all shears of equal grains in space at 93.7 %, without a basis.
struct MeasuredFilmsInSpace {
  double grains;
  int divisions;
  double unknowns, bytes;
};

const std::vector<MeasuredFilmsInSpace> measured_films_in_space = {
    {27.0, 1, 23549, 329e6},    {64.0, 1, 56373, 797e6},   {125.0, 1, 108621, 1855e6}, {27.0, 2, 93589, 1199e6},
    {216.0, 1, 192765, 2555e6}, {64.0, 2, 224057, 2486e6}, {343.0, 1, 301013, 4744e6}};

TEST(FilmCosts, InSpaceAreNotLessThanThoseOfMeasuredRuns) {
  for (const auto& [count, divisions, unknowns, bytes] : measured_films_in_space) {
    auto study = study_of_grains(1e-4 * std::cbrt(std::numbers::pi / 6.0 * count));
    study.stages.front().packing = LaguerrePacking<3>{};
    study.tests.films.divisions = divisions;
    const auto grains = expected_grains(study.stages.front());
    EXPECT_EQ(grains.count, count);
    EXPECT_NEAR(film_unknowns(study.tests, grains) / unknowns, 1.0, 0.1) << count;
    const double estimate = film_memory(study, study.stages.front(), grains);
    EXPECT_GT(estimate, 0.95 * bytes) << count;
    EXPECT_LT(estimate, 1.6 * bytes) << count;
  }
}

TEST(FilmCosts, GrowWithTheGrainsAndTheLayers) {
  auto study = study_of_grains(1e-3);
  const auto& stage = study.stages.front();
  double last_seconds = 0.0;
  for (const std::optional<int> layers : {std::optional<int>(), std::optional(2), std::optional(6)}) {
    study.tests.films.layers = layers;
    const double few = film_memory(study, stage, {25.0, 0.03}), many = film_memory(study, stage, {100.0, 0.03});
    EXPECT_GT(many, few);
    EXPECT_GT(film_time(study, stage, {100.0, 0.03}), last_seconds);
    last_seconds = film_time(study, stage, {100.0, 0.03});
  }
}

// The layers near the faces are thinner in thinner films, and so are the elements along them; 25 grains.
TEST(FilmCosts, OfUnknownsGrowsAsResolvedFilmsBecomeThinner) {
  constexpr std::array<std::array<double, 3>, 4> counted = {
      {{0.85, 27895, 138501}, {0.937, 40575, 166097}, {0.98, 57351, 200273}, {0.995, 79065, 240257}}};
  for (const auto& [fraction, of_two, of_six] : counted) {
    auto study = study_of_grains(0.443e-3);
    study.stages.front().fillers.front().fraction = fraction;
    const auto grains = expected_grains(study.stages.front());
    study.tests.films.layers = 2;
    EXPECT_NEAR(film_unknowns(study.tests, grains) / of_two, 1.0, 0.2) << fraction;
    study.tests.films.layers = 6;
    EXPECT_NEAR(film_unknowns(study.tests, grains) / of_six, 1.0, 0.2) << fraction;
  }
}

// A hexagon of the area a keeps (1 - t / 2r)^2 of it, with the apothem r = sqrt(a / 2 sqrt(3)).
TEST(FilmCosts, ExpectsTheFilmsOfHexagons) {
  const auto equal = expected_grains(study_of_grains(0.886e-3).stages.front());
  EXPECT_NEAR(equal.count, 100.0, 1.0);
  EXPECT_NEAR(equal.film, 2.0 * std::sqrt(1.0 / (2.0 * std::sqrt(3.0))) * (1.0 - std::sqrt(0.937)), 1e-12);

  auto listed = study_of_grains(1e-3).stages.front();
  listed.fillers.front().fraction = {};
  listed.packing = LaguerrePacking<2>{.film = 2e-6, .sites = std::vector<Site<2>>(16)};
  EXPECT_EQ(expected_grains(listed).count, 16.0);
  EXPECT_NEAR(expected_grains(listed).film, 2e-3 * 4.0, 1e-15);
}

TEST(FilmCosts, FieldsTakeTheirFiles) {
  auto study = study_of_grains(0.443e-3);
  const auto& stage = study.stages.front();
  const auto grains = expected_grains(stage);
  const double without = film_memory(study, stage, grains);
  study.tests.field_times = {1e-2};
  const double with_fields = film_memory(study, stage, grains);
  EXPECT_GT(with_fields, without);
  study.tests.films.layers = 2;
  const double resolved = film_memory(study, stage, grains);
  study.tests.field_times = {};
  EXPECT_EQ(film_memory(study, stage, grains), resolved) << "resolved films have no fields";
}

TEST(FilmCosts, TooLittleMemoryIsRefusedWithTheGrainsThatWouldFit) {
  const auto study = study_of_grains(2.8e-3);
  const auto& stage = study.stages.front();
  const auto grains = expected_grains(stage);
  const double bytes = film_memory(study, stage, grains);
  EXPECT_NO_THROW(require_memory(study, bytes));
  EXPECT_THAT(test::message_of<LackingMemory>([&] { require_memory(study, 0.999 * bytes); }),
              testing::MatchesRegex("grains: 998 grains and films take about .* GB, and .* GB are "
                                    "left; 99[0-9] grains would fit"));
  EXPECT_THAT(test::message_of<LackingMemory>([&] { require_memory(study, 1e6); }),
              testing::Not(testing::HasSubstr("would fit")));
}

}  // namespace
}  // namespace breccia
