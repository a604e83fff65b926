#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr auto times = "times = [\"10 ns\", \"10 ms\"]\n";

class DeckTests : public testing::Test {
 protected:
  [[nodiscard]] static std::string deck(std::string_view lines) {
    return test::join(test::materials, test::stage, "[tests]\n", lines);
  }
  [[nodiscard]] Tests tests(std::string_view lines) const { return directory.study(deck(lines)).tests; }
  [[nodiscard]] std::string mistakes(std::string_view lines) const { return directory.mistakes(deck(lines)); }

  test::DeckDirectory directory;
};

TEST_F(DeckTests, Defaults) {
  const auto defaults = tests(times);
  EXPECT_THAT(defaults.loads, ElementsAre(TestLoad::isotropic()));
  EXPECT_THAT(defaults.boundaries, ElementsAre(Boundary::periodic));
  EXPECT_THAT(defaults.methods, ElementsAre(Method::quasistatic));
  EXPECT_EQ(defaults.quasistatic.solver, Solver::reduced);
  EXPECT_EQ(defaults.volumetric, Volumetric::averaged);
  EXPECT_EQ(defaults.quasistatic.range, SampledRange::matrix);
  EXPECT_EQ(defaults.quasistatic.linear.method, LinearMethod::automatic);
  EXPECT_EQ(defaults.first_time, 1e-8);
  EXPECT_EQ(defaults.last_time, 1e-2);
  EXPECT_EQ(defaults.points_per_decade, 20);
  EXPECT_EQ(defaults.dynamic.courant, DynamicOptions().courant);
  EXPECT_THAT(defaults.dynamic.mass_scaling_factors, IsEmpty());
  EXPECT_THAT(defaults.field_times, ElementsAre(defaults.last_time));
}

constexpr std::string_view second_stage = R"([[stages]]
name = "second"
matrix = "HB-1"
box = "1 mm"
cells = 20
filler = { material = "hmx", fraction = 0.3, sizes = { diameter = "0.2 mm" } }
packing = { method = "random-sequential", walls = true }
)";

TEST_F(DeckTests, ARandomPackingHasWallsBesideAStageThatAsksForThem) {
  const auto two = directory.study(test::join(test::materials, test::stage, second_stage, "[tests]\n", times));
  EXPECT_EQ(two.stages.at(0).packed_by<LubachevskyStillingerPacking<2>>()->walls, Walls::hard);
  EXPECT_THAT(two.tests.boundaries, ElementsAre(Boundary::displacement, Boundary::traction));
}

// Tasks of a sweep share a stage whose hash is the same; its default boundaries depend on the stages after it.
TEST_F(DeckTests, TheHashOfAStageHasItsBoundaries) {
  const auto hash_with = [&](const std::string& later) {
    const auto study =
        directory.study(test::join(test::materials, test::stage, later, "[tests]\nmixing = \"series\"\n", times));
    return study.provenance.stage_hashes.at(0);
  };
  const std::string with_walls(second_stage);
  EXPECT_EQ(hash_with(with_walls), hash_with(test::replaced(with_walls, "0.3", "0.4")));
  EXPECT_NE(hash_with(with_walls), hash_with(test::replaced(with_walls, "walls = true", "walls = false")));
}

TEST_F(DeckTests, APeriodicBoxIsTestedUnderThePeriodicBoundaryAlone) {
  const auto periodic = test::replaced(std::string(test::stage), "stillinger\"", "stillinger\", walls = false");
  const auto boundaries_of = [&](std::string_view lines) {
    return directory.study(test::join(test::materials, periodic, "[tests]\n", times, lines)).tests.boundaries;
  };
  EXPECT_THAT(boundaries_of(""), ElementsAre(Boundary::periodic));
  EXPECT_THAT(boundaries_of("boundaries = [\"displacement\"]"), ElementsAre(Boundary::displacement))
      << "as the deck wishes";
}

constexpr std::string_view grains = R"([[stages]]
name = "grains"
matrix = "binder"
box = "6 mm"
filler = { material = "hmx", fraction = 0.94, sizes = { diameter = "1 mm" } }
packing = { method = "laguerre" }
)";

TEST_F(DeckTests, GrainsComputedWithFilmsNeedNoCells) {
  const auto deck_of = [&](std::string_view stage, std::string_view lines) {
    return test::join(test::materials, stage, "[tests]\n", times, lines);
  };
  const auto study = directory.study(deck_of(grains, "model = \"films\"\nfilms = { face_share = 0.1 }\n"));
  EXPECT_EQ(study.tests.model, Model::films);
  EXPECT_EQ(study.tests.films.face_share, 0.1);
  EXPECT_EQ(study.tests.quasistatic.sampling.tolerance, 1e-4);
  EXPECT_EQ(study.stages.front().cells, 512) << "of the labels";
  EXPECT_NE(directory.study(deck_of(grains, "")).stages.front().cells, 512) << "chosen for their error";
  EXPECT_THAT(directory.mistakes(deck_of(grains, "model = \"film\"\n")), HasSubstr("\"films\""));
  EXPECT_THAT(directory.mistakes(deck_of(test::stage, "films = { face_share = 0.1 }\n")),
              HasSubstr("it belongs to model = \"films\""));
  EXPECT_THAT(directory.mistakes(deck_of(test::stage, "model = \"films\"\n")), HasSubstr("is for grains"));
  const auto stepping = deck_of(grains, "model = \"films\"\nsolver = \"stepping\"\nfields = [\"1 us\"]\n");
  EXPECT_EQ(directory.study(stepping).tests.quasistatic.solver, Solver::stepping);
}

TEST_F(DeckTests, FilmsInSpaceHaveDivisions) {
  const auto deck_of = [&](std::string_view stage, std::string_view lines) {
    return "dimensions = 3\n" + test::join(test::materials, stage, "[tests]\n", times, "model = \"films\"\n", lines);
  };
  const auto study = directory.study(deck_of(grains, "films = { divisions = 3 }\n"));
  EXPECT_EQ(study.tests.films.divisions, 3);
  EXPECT_EQ(study.stages.front().cells, 96) << "of the labels";
  EXPECT_TRUE(has_fields(study.tests, study.stages.front()));
  EXPECT_EQ(directory.study(deck_of(grains, "")).tests.films.divisions, 2);
  EXPECT_THAT(directory.mistakes(deck_of(grains, "films = { divisions = 9 }\n")),
              HasSubstr("expected an integer from 1 to 8, got 9"));
  EXPECT_THAT(directory.mistakes(deck_of(grains, "films = { divisions = 1.5 }\n")), HasSubstr("integer"));
  EXPECT_THAT(directory.mistakes(deck_of(grains, "films = { face_share = 0.3 }\n")), HasSubstr("of two dimensions"));

  EXPECT_THAT(directory.mistakes(deck_of(grains, "fields = [\"1 us\"]\nfilms = { layers = 1 }\n")),
              HasSubstr("films that are resolved leave no fields"));
  EXPECT_THAT(directory.mistakes(deck_of(grains, "boundaries = [\"traction\"]\n")),
              HasSubstr("expected the boundary \"periodic\""));
  const auto walled = test::replaced(std::string(grains), "\"laguerre\"", R"("laguerre", walls = "cut")");
  EXPECT_THAT(directory.mistakes(deck_of(walled, "")), HasSubstr("in three dimensions: expected a periodic box"));
}

TEST_F(DeckTests, FilmsOfListedSitesNeedNoCells) {
  directory.write("sites.csv", "x_um,y_um\n1000,1000\n4000,2000\n2000,5000\n");
  const auto listed = test::replaced(std::string(grains), "\"laguerre\"", R"("laguerre", sites = "sites.csv")");
  const auto deck = test::join(test::materials, test::replaced(listed, ", sizes = { diameter = \"1 mm\" }", ""),
                               "[tests]\n", times, "model = \"films\"\n");
  EXPECT_EQ(directory.study(deck).stages.front().cells, 512);
}

TEST_F(DeckTests, SharesOfFilmsAreOfThePlaneAlone) {
  directory.write("sites.csv", "x_m,y_m,z_m,film_share\n1e-3,1e-3,1e-3,1\n4e-3,2e-3,3e-3,2\n");
  const auto listed = test::replaced(std::string(grains), "\"laguerre\"", R"("laguerre", sites = "sites.csv")");
  const auto deck =
      "dimensions = 3\n" + test::join(test::materials, test::replaced(listed, ", sizes = { diameter = \"1 mm\" }", ""),
                                      "[tests]\n", times, "model = \"films\"\n");
  EXPECT_THAT(directory.mistakes(deck), HasSubstr("expected sites without film_share"));
}

TEST_F(DeckTests, DivisionsAreOfSpaceAlone) {
  const auto deck =
      test::join(test::materials, grains, "[tests]\n", times, "model = \"films\"\n", "films = { divisions = 2 }\n");
  EXPECT_THAT(directory.mistakes(deck), HasSubstr("of three dimensions"));
}

TEST_F(DeckTests, FilmsMayBeResolvedByLayers) {
  const auto deck_of = [&](std::string_view lines) {
    return test::join(test::materials, grains, "[tests]\n", times, "model = \"films\"\n", lines);
  };
  EXPECT_FALSE(directory.study(deck_of("")).tests.films.layers);
  EXPECT_EQ(directory.study(deck_of("films = { layers = 4 }\n")).tests.films.layers, 4);
  EXPECT_THAT(directory.mistakes(deck_of("films = { layers = 0 }\n")), HasSubstr("layers"));
}

TEST_F(DeckTests, ResolvedFilmsHaveNoFields) {
  const auto deck_of = [&](std::string_view lines) {
    return test::join(test::materials, grains, "[tests]\n", times, "model = \"films\"\n", lines);
  };
  EXPECT_THAT(directory.mistakes(deck_of("films = { layers = 2 }\nfields = [\"1 us\"]\n")),
              HasSubstr("films.layers: films that are resolved leave no fields: expected fields = \"none\""));
  const auto without_times = directory.study(deck_of("films = { layers = 2 }\n"));
  EXPECT_FALSE(has_fields(without_times.tests, without_times.stages.front()));
  const auto thin = directory.study(deck_of("fields = [\"1 us\"]\n"));
  EXPECT_TRUE(has_fields(thin.tests, thin.stages.front()));
}

TEST_F(DeckTests, GrainsThatTheWallsCutHaveBothBounds) {
  const auto cut = test::replaced(std::string(grains), "\"laguerre\"", R"("laguerre", walls = "cut")");
  const auto study = directory.study(test::join(test::materials, cut, "[tests]\n", times, "model = \"films\"\n"));
  EXPECT_THAT(study.tests.boundaries, ElementsAre(Boundary::displacement, Boundary::traction));
  EXPECT_THAT(directory.mistakes(test::join(test::materials, cut, "[tests]\n", times,
                                            "model = \"films\"\nboundaries = [\"periodic\"]\n")),
              HasSubstr("expected the boundaries \"displacement\" and \"traction\""));
}

TEST_F(DeckTests, FieldsAreWantedAtTheseTimes) {
  EXPECT_THAT(tests(test::join(times, "fields = \"last\"")).field_times, ElementsAre(1e-2));
  EXPECT_THAT(tests(test::join(times, "fields = \"none\"")).field_times, IsEmpty());
  EXPECT_FALSE(tests(test::join(times, "fields = \"last\"")).lists_field_times);
  EXPECT_TRUE(tests(test::join(times, "fields = [\"10 ms\"]")).lists_field_times);
  EXPECT_THAT(tests(test::join(times, "fields = [\"1 us\", \"10 ms\"]")).field_times, ElementsAre(1e-6, 1e-2));
}

TEST_F(DeckTests, EverythingOfTheQuasistaticMethod) {
  const auto given = tests(test::join(times, R"(loads = ["shear-xx-yy", "bulk"]
boundaries = ["traction", "periodic"]
method = ["quasistatic"]
solver = "stepping"
volumetric = "standard"
[tests.quasistatic]
tolerance = 1e-4
range = "times"
steps_per_decade = 40
linear = "iterative"
linear_tolerance = 1e-8
)"));
  EXPECT_THAT(given.loads, ElementsAre(Load::diagonal_shear, Load::bulk));
  EXPECT_THAT(given.boundaries, ElementsAre(Boundary::traction, Boundary::periodic));
  EXPECT_EQ(given.quasistatic.solver, Solver::stepping);
  EXPECT_EQ(given.volumetric, Volumetric::standard);
  EXPECT_EQ(given.quasistatic.sampling.tolerance, 1e-4);
  EXPECT_EQ(given.quasistatic.range, SampledRange::times);
  EXPECT_EQ(given.quasistatic.steps_per_decade, 40);
  EXPECT_EQ(given.quasistatic.linear.method, LinearMethod::iterative);
  EXPECT_EQ(given.quasistatic.linear.tolerance, 1e-8);
}

TEST_F(DeckTests, BothMethods) {
  const auto given = tests(test::join(times, R"(method = ["quasistatic", "dynamic"])"));
  EXPECT_THAT(given.methods, ElementsAre(Method::quasistatic, Method::dynamic));
}

TEST_F(DeckTests, EverythingOfTheDynamicMethod) {
  const auto given = tests(test::join(times, R"(loads = ["bulk", "shear"]
boundaries = ["displacement"]
method = "dynamic"
volumetric = "standard"
points_per_decade = 10
[tests.dynamic]
formulation = "classical"
start = "affine"
courant = 1
ramp = "0.1 ms"
mass_scaling_factors = [1, 4, 100]
overlap = 50
reduction_tolerance = 1e-4
)"));
  EXPECT_THAT(given.loads, ElementsAre(Load::bulk, Load::shear));
  EXPECT_EQ(given.points_per_decade, 10);
  EXPECT_EQ(given.volumetric, Volumetric::standard);
  EXPECT_EQ(given.dynamic.formulation, Formulation::classical);
  EXPECT_EQ(given.dynamic.start, Start::affine);
  EXPECT_EQ(given.dynamic.courant, 1.0);
  EXPECT_DOUBLE_EQ(given.dynamic.ramp_time.value(), 1e-4);
  EXPECT_THAT(given.dynamic.mass_scaling_factors, ElementsAre(1.0, 4.0, 100.0));
  EXPECT_EQ(given.dynamic.overlap, 50.0);
  EXPECT_EQ(given.dynamic.reduction_tolerance, 1e-4);
}

TEST_F(DeckTests, MassScalingFactorsMayBeLeftToTheProgram) {
  EXPECT_THAT(tests(test::join(times, "dynamic = { mass_scaling_factors = \"auto\" }")).dynamic.mass_scaling_factors,
              IsEmpty());
}

TEST_F(DeckTests, MassScalingFactorsMayHaveTheirEarlierName) {
  const auto given = tests(test::join(times, "dynamic = { density_factors = [1, 4] }"));
  EXPECT_THAT(given.dynamic.mass_scaling_factors, ElementsAre(1.0, 4.0));
}

// 1 / (2 pi f), the last frequency first.
TEST_F(DeckTests, FrequenciesStandForTimes) {
  const auto tests_of = tests(R"(frequencies = ["0.01 Hz", "1 kHz"])");
  EXPECT_NEAR(tests_of.first_time / 1.5915494309189535e-4, 1.0, 1e-14);
  EXPECT_NEAR(tests_of.last_time / 15.915494309189535, 1.0, 1e-14);
  EXPECT_TRUE(tests_of.by_frequency);
  EXPECT_FALSE(tests(times).by_frequency);
}

TEST_F(DeckTests, CellsHaveFlowWhereItIsSupportedUnlessPointsAreStandard) {
  const auto mixing = [&](std::string_view lines) { return tests(test::join(times, lines)).mixing; };
  EXPECT_EQ(mixing(""), Mixing::flow);
  EXPECT_EQ(mixing("mixing = \"series\""), Mixing::series);
  EXPECT_EQ(mixing("method = [\"quasistatic\", \"dynamic\"]"), Mixing::series);
  EXPECT_EQ(mixing("volumetric = \"standard\""), Mixing::points);
  EXPECT_EQ(mixing("mixing = \"points\""), Mixing::points);
  EXPECT_EQ(mixing("mixing = \"flow\""), Mixing::flow);
}

TEST_F(DeckTests, LoadsMayBeAllShears) {
  EXPECT_THAT(tests(test::join(times, "loads = \"isotropic\"")).loads, ElementsAre(TestLoad::isotropic()));
  EXPECT_THAT(tests(test::join(times, "loads = [\"isotropic\", \"bulk\"]")).loads,
              ElementsAre(TestLoad::isotropic(), TestLoad(Load::bulk)));
}

TEST_F(DeckTests, Mistakes) {
  const auto with_times = [&](std::string_view lines) { return mistakes(test::join(times, lines)); };
  EXPECT_THAT(mistakes(""),
              HasSubstr("tests.times: missing, expected two rising times, such as [\"10 ns\", \"10 ms\"], or "
                        "frequencies instead"));
  EXPECT_THAT(mistakes("times = [\"1 s\"]"), HasSubstr("tests.times: expected two rising times"));
  EXPECT_THAT(mistakes("frequencies = [\"1 Hz\"]"), HasSubstr("tests.frequencies: expected two rising frequencies"));
  EXPECT_THAT(mistakes("frequencies = [\"2 Hz\", \"1 Hz\"]"), HasSubstr("expected two rising frequencies"));
  EXPECT_THAT(mistakes("frequencies = [\"1 Hz\", \"2 s\"]"), HasSubstr("frequencies: expected a frequency, got"));
  EXPECT_THAT(mistakes("times = [\"1 s\", \"2 s\"]\nfrequencies = [\"1 Hz\", \"2 Hz\"]"),
              HasSubstr("tests.times: expected times or frequencies, got both"));
  EXPECT_THAT(mistakes("times = [\"1 s\", \"2 m\"]"), HasSubstr("tests.times: expected a time, got \"2 m\""));
  EXPECT_THAT(with_times("loads = [\"sheer\"]"), HasSubstr("got \"sheer\", did you mean \"shear\"?"));
  EXPECT_THAT(with_times("loads = \"shear\""),
              HasSubstr("tests.loads: expected \"isotropic\", \"stiffness\" or an array"));
  EXPECT_THAT(with_times("loads = [\"shear\", \"shear\"]"), HasSubstr("tests.loads: the same twice"));
  EXPECT_THAT(with_times("boundaries = [\"tracton\"]"), HasSubstr("got \"tracton\", did you mean \"traction\"?"));
  EXPECT_THAT(with_times("mixing = \"serial\""), HasSubstr("got \"serial\", did you mean \"series\"?"));
  EXPECT_THAT(
      with_times("mixing = \"series\"\nvolumetric = \"standard\""),
      HasSubstr(R"(mixing "series" takes the volumetric strains "averaged": expected these, or mixing "points")"));
  EXPECT_THAT(with_times("method = \"quasi\""), HasSubstr("tests.method: expected"));
  EXPECT_THAT(with_times("fields = \"10 ms\""),
              HasSubstr("tests.fields: expected times such as [\"1 ms\"], \"last\" or \"none\", got \"10 ms\""));
  EXPECT_THAT(with_times("fields = []"), HasSubstr("tests.fields: expected at least one"));
  EXPECT_THAT(with_times("fields = [\"1 ms\", \"1 us\"]"), HasSubstr("tests.fields: expected rising times"));
  EXPECT_THAT(with_times("fields = [\"1 ms\", \"1 h\"]"),
              HasSubstr("tests.fields: expected times within those of the tests, 10 ns to 10 ms, got 3600 s"));
  EXPECT_THAT(with_times("fields = [\"1 m\"]"), HasSubstr("tests.fields: expected a time, got \"1 m\""));
  EXPECT_THAT(mistakes("fields = [\"1 ms\"]"), ::testing::Not(HasSubstr("fields")));
  EXPECT_THAT(with_times("method = [\"dynamic\", \"dynamic\"]"), HasSubstr("tests.method: the same twice"));
  EXPECT_THAT(with_times("solver = \"stepped\""), HasSubstr("got \"stepped\""));
  EXPECT_THAT(with_times("quasistatic = { tolerance = 1 }"), HasSubstr("tests.quasistatic.tolerance: expected"));
  EXPECT_THAT(with_times("quasistatic = { range = \"all\" }"), HasSubstr("tests.quasistatic.range: expected"));
  EXPECT_THAT(with_times("quasistatic = { steps = 10 }"), HasSubstr("unknown key \"steps\""));
  EXPECT_THAT(with_times("points_per_decade = 0"),
              HasSubstr("tests.points_per_decade: expected an integer from 1 to 1000, got 0"));
}

TEST_F(DeckTests, ElasticMaterialsMayVary) {
  const auto varied = [&](std::string_view keys) { return tests(test::join(times, "[tests.quasistatic]\n", keys)); };
  const auto given = varied(R"(vary = { hmx = { shear = ["1 GPa", "10 GPa"], bulk = ["10 GPa", "20 GPa"] } })");
  ASSERT_EQ(given.varied.size(), 1U);
  EXPECT_EQ(given.varied[0].name, "hmx");
  EXPECT_EQ(given.varied[0].shear.value().least, 1e9);
  EXPECT_EQ(given.varied[0].shear.value().most, 10e9);
  EXPECT_EQ(given.varied[0].bulk.value().most, 20e9);
  EXPECT_EQ(given.quasistatic.sampling.tolerance, 1e-4) << "many parameters take many snapshots";
  EXPECT_EQ(
      varied("vary = { hmx = { shear = [\"1 GPa\", \"10 GPa\"] } }\ntolerance = 1e-6").quasistatic.sampling.tolerance,
      1e-6);
  EXPECT_THAT(tests(times).varied, IsEmpty());
}

TEST_F(DeckTests, MistakesInMaterialsThatVary) {
  const auto with = [&](std::string_view keys) {
    return mistakes(test::join(times, "[tests.quasistatic]\nvary = { ", keys, " }\n"));
  };
  EXPECT_THAT(with("hmxx = { shear = [\"1 GPa\", \"10 GPa\"] }"),
              HasSubstr("quasistatic.vary.hmxx: no stage has a material \"hmxx\", did you mean \"hmx\"?"));
  EXPECT_THAT(with("hmx = { shear = [\"10 GPa\", \"1 GPa\"] }"),
              HasSubstr("vary.hmx.shear: expected two rising moduli, such as [\"10 MPa\", \"1 GPa\"]"));
  EXPECT_THAT(with("hmx = { shear = [\"1 GPa\"] }"), HasSubstr("vary.hmx.shear: expected two rising moduli"));
  EXPECT_THAT(with("hmx = { shear = [\"1 GPa\", \"10 m\"] }"), HasSubstr("vary.hmx.shear: expected a pressure"));
  EXPECT_THAT(with("hmx = { shear = \"1 GPa\" }"), HasSubstr("vary.hmx.shear: expected an array"));
  EXPECT_THAT(with("hmx = [\"1 GPa\", \"10 GPa\"]"), HasSubstr("vary.hmx: expected a table"));
  const auto of_zero = with(R"(hmx = { shear = ["0 MPa", "10 GPa"] })");
  EXPECT_THAT(of_zero, HasSubstr("vary.hmx.shear: expected a positive pressure"));
  EXPECT_THAT(of_zero, testing::Not(HasSubstr("rising"))) << "one mistake, one line";
  EXPECT_THAT(mistakes(test::join(times,
                                  "method = \"dynamic\"\n[tests.quasistatic]\nvary = { hmx = { shear = "
                                  "[\"1 GPa\", \"10 GPa\"] } }\n")),
              HasSubstr("quasistatic.vary is for method \"quasistatic\""));
  EXPECT_THAT(with("hmx = { young = [\"1 GPa\", \"10 GPa\"] }"), HasSubstr("unknown key \"young\""));
  EXPECT_THAT(with("hmx = { shear = [\"1 GPa\", \"2 GPa\"] }"),
              HasSubstr("vary.hmx: the shear modulus of the material, 5.84 GPa, is not among 1 GPa to 2 GPa"));
}

TEST_F(DeckTests, MistakesInTheDynamicMethod) {
  const auto with = [&](std::string_view keys) { return mistakes(test::join(times, "dynamic = { ", keys, " }")); };
  EXPECT_THAT(with("courant = 1.5"),
              HasSubstr("tests.dynamic.courant: expected a number above 0 and up to 1, got 1.5"));
  EXPECT_THAT(with("ramp = \"1 s\", ramp_transits = 2"),
              HasSubstr("dynamic.ramp_transits: the ramp is given as a time"));
  EXPECT_THAT(with("mass_scaling_factors = [4, 1]"),
              HasSubstr("dynamic.mass_scaling_factors: expected rising numbers"));
  EXPECT_THAT(with("mass_scaling_factors = [0]"),
              HasSubstr("dynamic.mass_scaling_factors: expected a positive number, got 0"));
  EXPECT_THAT(with("mass_scaling_factors = \"all\""), HasSubstr("dynamic.mass_scaling_factors: expected \"auto\""));
  EXPECT_THAT(with("mass_scaling_factors = [1], density_factors = [1]"),
              HasSubstr("dynamic.density_factors: the earlier name of mass_scaling_factors, which is given already"));
  EXPECT_THAT(with("density_factors = [4, 1]"), HasSubstr("dynamic.density_factors: expected rising numbers"));
  EXPECT_THAT(with("damping = 1"), HasSubstr("tests.dynamic: unknown key \"damping\""));
}

TEST_F(DeckTests, ContradictionsBetweenValidSettings) {
  const auto soft = R"([materials.soft]
density = "1 g/cm^3"
bulk = "1 GPa"
shear = { terms = [{ time = "1 s", modulus = "1 MPa" }] }
[[stages]]
name = "S"
matrix = "binder"
box = "1 mm"
cells = 40
filler = { material = "soft", sizes = { diameter = "0.2 mm" } }
packing = { method = "regular", columns = 2, rows = 2 }
)";
  const auto with = [&](const char* tests) { return test::join(test::materials, soft, "[tests]\n", tests); };
  EXPECT_EQ(directory.study(with("times = [\"1 s\", \"9 s\"]")).stages.size(), 1U);
  EXPECT_EQ(directory.study(with("times = [\"1 s\", \"9 s\"]\nsolver = \"stepping\"")).stages.size(), 1U);
  EXPECT_THAT(directory.mistakes(with("times = [\"1 s\", \"9 s\"]\nsolver = \"stepping\"\npoints_per_decade = 1")),
              HasSubstr("give 2 times, of which no series can be fitted"));
}

}  // namespace
}  // namespace breccia
