#include "breccia/study/soundness.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "study/expected_mistakes.hpp"
#include "study/two_stages.hpp"

namespace breccia {
namespace {

using test::expect_each;
using test::mistakes_of;
using testing::AllOf;
using testing::HasSubstr;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Filler& filler_of(Study& study) {
  return study.stages[0].fillers[0];
}

/// A study of two stages, of which the first has a random packing.
Study with_random_packing(Sizes sizes) {
  auto study = test::two_stages();
  auto& filler = filler_of(study);
  study.stages[0].packing = LubachevskyStillingerPacking<2>{};
  filler.sizes = std::move(sizes);
  filler.fraction = 0.3;
  return study;
}

TEST(RequireSound, LetsAStudyPass) {
  EXPECT_NO_THROW(require_sound(test::two_stages()));
  EXPECT_NO_THROW(require_sound(with_random_packing(SingleSize{1e-3})));
}

TEST(RequireSound, NamesEveryMistakeAtOnce) {
  auto study = test::two_stages();
  study.stages[0].matrix = EarlierStage{"coarse"};
  study.stages[1].name = "";
  study.stages[1].side = -1.0;
  study.stages[1].coarser_cells = {24};
  study.stages[1].fillers[0].material.density = not_a_number;
  study.tests.boundaries.clear();
  study.tests.last_time = study.tests.first_time;
  EXPECT_THAT(mistakes_of(study),
              AllOf(HasSubstr("fine: no earlier stage \"coarse\" for its matrix"),
                    HasSubstr("stage 2: expected a name"), HasSubstr("side of the box: expected a length from"),
                    HasSubstr("rising from grid to grid"), HasSubstr("filler: density: expected a positive density"),
                    HasSubstr("expected a boundary condition"), HasSubstr("expected first_time < last_time")));
}

TEST(RequireSound, RefusesAStudyWithoutStages) {
  EXPECT_THAT(mistakes_of({}), HasSubstr("study: expected at least one stage"));
}

TEST(RequireSound, NamesEachMistakeOfMaterials) {
  expect_each({{[](Study& study) { study.title = "two\nlines"; }, "title: expected a text without control characters"},
               {[](Study& study) { study.materials.push_back({test::glass}); },
                "material glass: another material has this name"},
               {[](Study& study) { study.materials[0].material.density = 0.0; },
                "material binder: density: expected a positive density, got 0 kg/m^3"},
               {[](Study& study) { study.materials[0].material.bulk = PronySeries(0.0); },
                "material binder: unrelaxed bulk modulus: expected a positive pressure"},
               {[](Study& study) { study.materials[1].material.bulk = PronySeries(1e6); },
                "material glass: expected a Poisson's ratio above -0.9, got -0.9991 (bulk 1 MPa, shear 5 GPa); are the "
                "units right?"},
               {[](Study& study) { study.materials[0].material.name = "a\tb"; }, "expected a name without line breaks"},
               {[](Study& study) {
                  study.stages[0].matrix = Material{"binder", 1e3, PronySeries(1e9), {}};
                },
                "fine, matrix: unrelaxed shear modulus: expected a positive pressure"},
               {[](Study& study) {
                  study.materials[0].shift = {WilliamsLandelFerry{-17.4, 51.6, 290.0}, 300.0};
                },
                "temperature shift of binder: c1: expected a positive number, got -17.4"},
               {[](Study& study) {
                  study.materials[0].shift = {WilliamsLandelFerry{17.4, 51.6, 290.0}, 200.0};
                },
                "temperature shift of binder: the shift law has no meaning"}},
              test::two_stages());
}

TEST(RequireSound, NamesEachMistakeOfStages) {
  expect_each({{[](Study& study) { study.stages[1].name = "a/b"; }, "a/b: expected letters, digits"},
               {[](Study& study) { study.stages[1].name = std::string(201, 'a'); },
                "expected a name of at most 200 letters, got 201"},
               {[](Study& study) { study.stages[1].name = "fine"; }, "fine: another stage is called \"fine\""},
               {[](Study& study) { study.stages[1].name = "glass"; }, "glass: a material is called \"glass\""},
               {[](Study& study) { study.stages[1].name = "Study.json"; }, "is the name of a file of results"},
               {[](Study& study) { study.stages[1].side = infinity; }, "coarse: side of the box: expected a length"},
               {[](Study& study) { study.stages[1].cells = 1; },
                "coarse: cells per side: expected an integer from 2 to 1048576, got 1"},
               {[](Study& study) {
                  study.stages[1].coarser_cells = {8, 6};
                },
                "rising from grid to grid"},
               {[](Study& study) {
                  study.stages[1].coarser_cells = {4, 6, 8};
                },
                "coarse: expected at most 3 grids"}},
              test::two_stages());
}

TEST(RequireSound, NamesEachMistakeOfFillersInRegularPackings) {
  expect_each(
      {{[](Study& study) { filler_of(study).sizes.reset(); }, "fine, filler: expected sizes"},
       {[](Study& study) {
          filler_of(study).sizes = ListedSizes{{1e-3, 2e-3}};
        },
        "fine, filler: expected a single size for a regular packing"},
       {[](Study& study) { filler_of(study).sizes = SingleSize{3e-3}; },
        "fine, filler: particles of 3 mm touch at a regular spacing of 3 mm"},
       {[](Study& study) { filler_of(study).fraction = 0.3; }, "fine, filler: expected no fraction"},
       {[](Study& study) { filler_of(study).smallest = 1e-3; }, "fine, filler: expected no smallest and largest size"},
       {[](Study& study) { filler_of(study).gap = 1e-4; }, "fine, filler: expected no gap"},
       {[](Study& study) {
          study.stages[0].packing = RegularPacking{0, 2};
        },
        "fine, filler: columns: expected an integer from 1 to 10000, got 0"}},
      test::two_stages());
}

TEST(RequireSound, NamesEachMistakeOfFillersInRandomPackings) {
  expect_each(
      {{[](Study& study) { filler_of(study).fraction.reset(); }, "fine, filler: expected a fraction"},
       {[](Study& study) { filler_of(study).fraction = 1.0; },
        "fine, filler: fraction: expected a number between 0 and 1, got 1"},
       {[](Study& study) { filler_of(study).gap = -1e-6; },
        "fine, filler: gap: expected a non-negative length, got -1 um"},
       {[](Study& study) { filler_of(study).gap = 6e-3; }, "a gap of 6 mm does not fit into a box of 6 mm"},
       {[](Study& study) { filler_of(study).sizes = SingleSize{7e-3}; },
        "fine, filler: a particle of 7 mm does not fit into a box of 6 mm"},
       {[](Study& study) { filler_of(study).sizes = SingleSize{0.0}; }, "the diameter must be positive"},
       {[](Study& study) { filler_of(study).sizes = ListedSizes{{1e-3}}; }, "fine, filler: expected no fraction"},
       {[](Study& study) {
          filler_of(study).sizes = TabulatedSizes{"", {1e-4, 1e-3}, {0.0, 0.9}};
        },
        "cumulative shares must begin at 0 and end at 1"},
       {[](Study& study) {
          filler_of(study).sizes = LognormalSizes{{{1.0, 1e-3, 0.5}}};
        },
        "fine, filler: expected a smallest and a largest size: the distribution does not have both ends of its own"},
       {[](Study& study) { filler_of(study).sizes = FullerSizes{2e-3}; },
        "fine, filler: expected a smallest and a largest size"}},
      with_random_packing(SingleSize{1e-3}));
  auto listed = with_random_packing(ListedSizes{{1e-3, 2e-3}});
  filler_of(listed).fraction.reset();
  EXPECT_NO_THROW(require_sound(listed));
  expect_each({{[](Study& study) { filler_of(study).sizes = ListedSizes{}; }, "expected at least one diameter"},
               {[](Study& study) {
                  filler_of(study).sizes = ListedSizes{{1e-3, -1e-3}};
                },
                "expected positive diameters in the list"}},
              listed);
  auto lognormal = with_random_packing(LognormalSizes{{{1.0, 1e-3, 0.5}}});
  filler_of(lognormal).smallest = 0.5e-3;
  filler_of(lognormal).largest = 2e-3;
  EXPECT_NO_THROW(require_sound(lognormal));
  expect_each({{[](Study& study) { filler_of(study).smallest = 2e-3; }, "expected a smallest size below the largest"},
               {[](Study& study) { filler_of(study).sizes = LognormalSizes{}; },
                "a lognormal mixture needs at least one component"},
               {[](Study& study) {
                  filler_of(study).sizes = RosinRammlerSizes{1e-3, 0.0};
                },
                "the exponent of Rosin and Rammler must be positive and finite, got 0"},
               {[](Study& study) {
                  filler_of(study).sizes = QuantileSizes{1e-3, 1e-3, 2e-3};
                },
                "d10, d50 and d90 must rise strictly"}},
              lognormal);
}

TEST(RequireSound, NamesEachMistakeOfSeveralFillersAndCoatings) {
  auto sound = with_random_packing(SingleSize{1e-3});
  sound.stages[0].fillers.push_back(sound.stages[0].fillers[0]);
  sound.stages[0].fillers[1].coating = Coating{test::glass, 1e-5};
  EXPECT_NO_THROW(require_sound(sound));
  const auto second = [](Study& study) -> Filler& { return study.stages[0].fillers[1]; };
  expect_each(
      {{[&](Study& study) { second(study).fraction = 0.8; }, "fine: the fractions of all fillers add up to 1.1"},
       {[&](Study& study) { second(study).fraction.reset(); }, "fine, filler 1: expected a fraction"},
       {[&](Study& study) { second(study).coating->thickness = 0.0; },
        "fine, filler 1: thickness of the coating: expected a positive length"},
       {[&](Study& study) { second(study).coating->material.density = -1.0; },
        "fine, filler 1, coating: density: expected a positive density"},
       {[&](Study& study) { second(study).material.name = "matrix"; },
        "fine: a filler or coating of the material \"matrix\" has the name of another phase"},
       {[&](Study& study) {
          for (auto& filler : study.stages[0].fillers) filler.fraction.reset();
          study.stages[0].packing = RegularPacking{2, 2};
        },
        "fine, packing: expected one filler for a regular packing, got 2"},
       {[&](Study& study) {
          for (auto& filler : study.stages[0].fillers) filler = {.material = filler.material};
          study.stages[0].packing = ExplicitPacking<2>{"", std::vector{Disc{{2e-3, 2e-3}, 1e-3}}, Walls::hard, {2}};
        },
        "fine, packing: a particle is of filler 2, counted from 0, but there are only 2"}},
      sound);
}

TEST(RequireSound, NamesEachMistakeOfShapes) {
  auto sound = with_random_packing(SingleSize{1e-3});
  sound.stages[0].packing = RandomSequentialPacking<2>{};
  filler_of(sound).shape = FillerShape{EllipticOutline{1.5}, {}};
  EXPECT_NO_THROW(require_sound(sound));
  const auto with_outline = [](auto outline) {
    return [outline](Study& study) { filler_of(study).shape->outline = outline; };
  };
  expect_each({{with_outline(EllipticOutline{0.0}), "fine, filler: expected an aspect from 0.05 to 20, got 0"},
               {with_outline(PolygonalOutline{"", {{0.0, 0.0}, {1.0, 0.0}}}), "three corners or more"},
               {[](Study& study) { filler_of(study).shape->angle = std::nan(""); }, "expected a finite angle"},
               {[](Study& study) { study.stages[0].packing = LubachevskyStillingerPacking<2>{}; },
                "only a random sequential packing places other shapes than discs"}},
              sound);
}

TEST(RequireSound, NamesEachMistakeOfListedParticles) {
  auto sound = test::two_stages();
  filler_of(sound).sizes.reset();
  sound.stages[0].packing =
      ExplicitPacking<2>{"", std::vector{Particle{Ellipse{{2e-3, 1e-3}}, Pose({2e-3, 2e-3}, 0.0)}}};
  EXPECT_NO_THROW(require_sound(sound));
  const auto particles_of = [](Study& study) -> std::vector<Particle>& {
    return std::get<std::vector<Particle>>(study.stages[0].packed_by<ExplicitPacking<2>>()->particles);
  };
  auto flat = sound;
  particles_of(flat)[0].shape = Ellipse{{0.0, 1e-3}};
  EXPECT_THAT(mistakes_of(flat), HasSubstr("its axes must be positive"));
  auto twice = sound;
  particles_of(twice).push_back(particles_of(twice)[0]);
  EXPECT_THAT(mistakes_of(twice), HasSubstr("overlap by 0.001 m"));
}

TEST(RequireSound, NamesEachMistakeOfFillersInExplicitPackings) {
  auto sound = test::two_stages();
  filler_of(sound).sizes.reset();
  sound.stages[0].packing = ExplicitPacking<2>{"", std::vector{Disc{{2e-3, 2e-3}, 1e-3}}};
  EXPECT_NO_THROW(require_sound(sound));
  const auto with_discs = [](const std::vector<Disc>& discs) {
    return [discs](Study& study) { study.stages[0].packed_by<ExplicitPacking<2>>()->particles = discs; };
  };
  expect_each({{with_discs({}), "fine, filler: expected at least one particle"},
               {[](Study& study) { filler_of(study).sizes = SingleSize{1e-3}; },
                "fine, filler: expected neither sizes nor a fraction"}},
              sound);
  for (const auto& [discs, message] : std::vector<std::pair<std::vector<Disc>, std::string>>{
           {{{{2e-3, 7e-3}, 1e-3}}, "the centre is outside the box"},
           {{{{2e-3, 2e-3}, 0.0}}, "the diameter must be positive"},
           {{{{2e-3, 2e-3}, 1e-3}, {{2.5e-3, 2e-3}, 1e-3}}, "overlap by"}}) {
    auto study = sound;
    with_discs(discs)(study);
    EXPECT_THAT(mistakes_of(study), AllOf(HasSubstr("fine, filler: microstructure"), HasSubstr(message)));
  }
}

TEST(RequireSound, NamesEachMistakeOfTests) {
  expect_each(
      {{[](Study& study) { study.tests.last_time = infinity; }, "tests: expected first_time < last_time"},
       {[](Study& study) { study.tests.loads.clear(); }, "tests: expected a load"},
       {[](Study& study) {
          study.tests.loads = {Load::shear, Load::bulk, Load::shear};
        },
        "tests: the same load twice"},
       {[](Study& study) {
          study.tests.boundaries = {Boundary::traction, Boundary::traction};
        },
        "tests: the same boundary condition twice"},
       {[](Study& study) { study.tests.methods.clear(); }, "tests: expected a method"},
       {[](Study& study) {
          study.tests.methods = {Method::quasistatic, Method::quasistatic};
        },
        "tests: the same method twice"},
       {[](Study& study) { study.tests.points_per_decade = 0; },
        "tests: points per decade: expected an integer from 1 to 1000, got 0"},
       {[](Study& study) { study.tests.fit_tolerance = 0.0; }, "tests: tolerance of the fit: expected a number"},
       {[](Study& study) {
          study.tests.field_times = {20e-3, 10e-3};
        },
        "tests, times of fields: expected rising times"},
       {[](Study& study) { study.tests.field_times = {1.0}; },
        "tests, times of fields: expected times within those of the tests, 1 ms to 50 ms, got 1 s"}},
      test::two_stages());
}

TEST(RequireSound, NamesEachMistakeOfTheOptionsOfMethods) {
  expect_each(
      {{[](Study& study) { study.tests.quasistatic.sampling.tolerance = 0.0; }, "method: tolerance of the sampling:"},
       {[](Study& study) { study.tests.quasistatic.steps_per_decade = 1; }, "method: steps per decade:"},
       {[](Study& study) { study.tests.quasistatic.linear.tolerance = 0.1; },
        "method: tolerance of the linear systems:"},
       {[](Study& study) { study.tests.quasistatic.linear.energy_tolerance = 0.0; },
        "method: tolerance of the energy in three dimensions:"},
       {[](Study& study) { study.tests.quasistatic.linear.energy_tolerance = not_a_number; },
        "method: tolerance of the energy in three dimensions:"},
       {[](Study& study) { study.tests.quasistatic.sampling.most_snapshots = 0; },
        "method: largest number of snapshots: expected an integer from 2 to 10000, got 0"},
       {[](Study& study) { study.tests.quasistatic.linear.threads = -1; }, "method: threads:"},
       {[](Study& study) { study.tests.quasistatic.linear.most_unknowns_direct = -1; },
        "method: largest number of unknowns of a direct solver:"},
       {[](Study& study) { study.tests.dynamic.courant = 1.1; },
        "tests, dynamic method: Courant number: expected a number above 0 and up to 1, got 1.1"},
       {[](Study& study) { study.tests.dynamic.ramp_transits = -1.0; }, "method: transits of the strain ramp:"},
       {[](Study& study) { study.tests.dynamic.creep_ramp_transits = -1.0; }, "method: transits of the traction ramp:"},
       {[](Study& study) { study.tests.dynamic.ramp_time = -1.0; }, "method: time of the ramp:"},
       {[](Study& study) {
          study.tests.dynamic.mass_scaling_factors = {0.0, 1.0};
        },
        "method: mass scaling factor:"},
       {[](Study& study) {
          study.tests.dynamic.mass_scaling_factors = {4.0, 1.0};
        },
        "mass scaling factors: expected rising"},
       {[](Study& study) { study.tests.dynamic.overlap = 1.0; }, "method: overlap:"},
       {[](Study& study) { study.tests.dynamic.reduction_tolerance = not_a_number; },
        "method: tolerance of the reduction:"}},
      test::two_stages());
}

TEST(RequireSound, NamesMethodsThatCannotBeUsedOnTheStages) {
  auto study = test::two_stages();
  filler_of(study).coating = Coating{test::binder, 1e-5};
  filler_of(study).material = test::binder;
  EXPECT_NO_THROW(require_sound(study)) << "fillers and coatings may relax";
  study.tests.quasistatic.solver = Solver::stepping;
  EXPECT_NO_THROW(require_sound(study));
  study.tests.points_per_decade = 1;
  study.tests.last_time = 5e-3;
  EXPECT_THAT(mistakes_of(study), HasSubstr("give 2 times, of which no series can be fitted"));
}

TEST(RequireSound, NamesWhatMixedCellsDoNotServe) {
  auto study = test::two_stages();
  study.tests.mixing = Mixing::series;
  EXPECT_NO_THROW(require_sound(study));
  study.tests.volumetric = Volumetric::standard;
  EXPECT_THAT(mistakes_of(study), HasSubstr(R"(takes the volumetric strains "averaged")"));
}

TEST(RequireSound, NamesWhatFlowThroughGapsDoesNotServe) {
  auto study = test::two_stages();
  study.tests.mixing = Mixing::flow;
  EXPECT_NO_THROW(require_sound(study));
  study.tests.methods = {Method::quasistatic, Method::dynamic};
  EXPECT_THAT(mistakes_of(study), HasSubstr(R"(mixing "flow": expected method "quasistatic")"));
  study.tests.methods = {Method::quasistatic};
  study.tests.volumetric = Volumetric::standard;
  EXPECT_THAT(mistakes_of(study), HasSubstr(R"(mixing "flow" takes the volumetric strains "averaged")"));
  study.tests.volumetric = Volumetric::averaged;
  study.tests.boundaries = {Boundary::periodic};
  EXPECT_THAT(mistakes_of(study), HasSubstr(R"(mixing "flow": stage fine: expected the boundaries "displacement")"));
  study.tests.boundaries = {Boundary::displacement};
  study.tests.varied = {{.name = test::glass.name}};
  EXPECT_THAT(mistakes_of(study), HasSubstr(R"(mixing "flow": expected no quasistatic.vary)"));
  study.tests.varied.clear();
  study.stages.back().packing = PackingMethod<2>(LaguerrePacking<2>{.walls = Walls::hard, .wall_film = WallFilm::none});
  EXPECT_THAT(mistakes_of(study), HasSubstr(R"(expected packing.walls other than "cut")"));
  study.stages.back().packing = PackingMethod<3>();
  study.stages.back().fillers.front().shape = FillerShape{EllipticOutline{2.0}};
  EXPECT_THAT(mistakes_of(study),
              AllOf(HasSubstr("in three dimensions: expected a periodic box (packing.walls = false)"),
                    HasSubstr("stage coarse: in three dimensions: expected spheres")));
}

}  // namespace
}  // namespace breccia
