#include "homogenisation/plan/film_error.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "breccia/homogenisation/stage_microstructure.hpp"

namespace breccia {
namespace {

const Material binder = {"binder", 1.0, PronySeries(4e9), PronySeries(1e6, {{1.0, 1e9}})};
const Material grain = {"grain", 2.0, PronySeries(13e9), PronySeries(6e9)};

/// A study of 100 grains of 1 mm, or of as many cells as `along` cubed in space, by the model of films.
template <int dim>
Study study_of(int along) {
  Study study;
  study.tests.model = Model::films;
  Stage stage{.name = "A", .matrix = binder, .side = 1e-3 * along, .cells = 64};
  stage.packing = LaguerrePacking<dim>{};
  stage.fillers = {{.material = grain, .fraction = 0.93, .sizes = SingleSize{1e-3}}};
  study.stages = {stage};
  return study;
}

/// Its grains, whose films have a thickness over the side of a grain.
template <int dim>
StageMicrostructure grains_of(int along, double film) {
  const auto count = static_cast<std::size_t>(std::pow(along, dim));
  StageMicrostructure packed;
  packed.box = Box<dim>(Grains<dim>{{}, {.film = 1e-3 * film, .count = count, .cell_count = count}});
  return packed;
}

// Random boxes of the plane were 1.8, 3.3 and 1.7 % off resolved films at 0.026, 0.0051 and 0.09.
TEST(FilmError, OfThePlaneIsThatOfElementsAndOfThickFilms) {
  auto study = study_of<2>(10);
  const auto error = [&](double film) { return film_error(study, study.stages[0], grains_of<2>(10, film)).value(); };
  EXPECT_NEAR(error(0.026), 0.02713, 1e-4);
  EXPECT_NEAR(error(0.005), 0.05044, 1e-4);
  EXPECT_NEAR(error(0.09), 0.02945, 1e-4);
  study.tests.films.face_share = 0.15;
  EXPECT_NEAR(error(0.005), 0.01374, 1e-4);
  study.tests.films.face_share = 0.05;
  EXPECT_NEAR(error(0.005), 0.01374, 1e-4) << "finer elements were not measured";
}

TEST(FilmError, OfSpaceFallsWithTheElements) {
  auto study = study_of<3>(3);
  const auto error = [&](int divisions) {
    study.tests.films.divisions = divisions;
    return film_error(study, study.stages[0], grains_of<3>(3, 0.02)).value();
  };
  EXPECT_GT(error(1), error(2));
  EXPECT_EQ(error(4), error(2)) << "the rest is that of thin films";
}

TEST(FilmError, IsNotKnownWhereItWasNotMeasured) {
  const auto study = study_of<2>(10);
  const auto thin = grains_of<2>(10, 0.02);
  const auto error = [&](const auto& change) {
    auto changed = study;
    change(changed);
    return film_error(changed, changed.stages[0], thin);
  };
  EXPECT_TRUE(error([](Study&) {}));
  EXPECT_FALSE(error([](Study& of) { of.tests.model = Model::cells; }));
  EXPECT_FALSE(error([](Study& of) { of.tests.films.layers = 2; }));
  EXPECT_FALSE(error([](Study& of) { of.tests.films.face_share = 0.5; }));
  EXPECT_FALSE(error([](Study& of) { of.stages[0].bonds = FilmBonds{.debonded = 0.1}; }));
  EXPECT_FALSE(error([](Study& of) { of.stages[0].fillers[0].material.shear = PronySeries(1e8); }));
  EXPECT_FALSE(error([](Study& of) { of.stages[0].packed_by<LaguerrePacking<2>>()->film_shares = {1.0, 2.0}; }));
  EXPECT_FALSE(error([](Study& of) { of.stages[0].packed_by<LaguerrePacking<2>>()->walls = Walls::hard; }));
  EXPECT_FALSE(film_error(study, study.stages[0], grains_of<2>(10, 0.2)));
  auto wide = thin;
  wide.fillers = {{.smallest_diameter = 1e-4, .largest_diameter = 2e-3}};
  EXPECT_FALSE(film_error(study, study.stages[0], wide));
  const auto space = study_of<3>(3);
  EXPECT_FALSE(film_error(space, space.stages[0], grains_of<3>(3, 0.1)));
  EXPECT_FALSE(film_error(space, space.stages[0], grains_of<3>(3, 0.001)));
}

}  // namespace
}  // namespace breccia
