#include "deck/tests.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "deck/time_window.hpp"
#include "deck/varied_materials.hpp"
#include "study/limits.hpp"
#include "study/test_rules.hpp"

namespace breccia {

namespace {

/// Reports an array that has an element twice.
template <class T>
void refuse_repeats(const Section& section, const std::string& key, const std::vector<T>& values) {
  if (has_repeats(values)) section.report(key, "the same twice");
}

/// Reads the mass scaling factors, also under the earlier name of their key.
std::vector<double> read_mass_scaling_factors(const Section& section) {
  const std::string earlier = "density_factors";
  const std::string key = section.has("mass_scaling_factors") ? "mass_scaling_factors" : earlier;
  if (key != earlier) section.refuse({earlier}, "the earlier name of mass_scaling_factors, which is given already");
  if (!section.has(key)) return {};
  if (section.kind(key) == Kind::text) {
    static_cast<void>(section.choice<bool>(key, {{"auto", true}}));
    return {};
  }
  auto factors = section.numbers(key, Range::positive());
  if (!is_rising(factors)) section.report(key, "expected rising numbers");
  return factors;
}

/// Reads the times of fields: the last time, none, or an array of times within those of the tests.
std::vector<double> read_field_times(const Section& section, const std::optional<TimeWindow>& window) {
  const auto times = window.value_or(TimeWindow{0.0, std::numeric_limits<double>::infinity()});
  if (!section.has("fields")) return {times.end};
  if (section.kind("fields") == Kind::text) {
    const auto word = section.text("fields");
    if (word == "last") return {times.end};
    if (word != "none") {
      section.report("fields", fmt::format(R"(expected times such as ["1 ms"], "last" or "none", got "{}")", word));
    }
    return {};
  }
  auto fields = section.quantities("fields", Dimension::time, Range::positive());
  // An invalid time has been reported already and is NaN here.
  if (std::ranges::any_of(fields, [](double time) { return std::isnan(time); })) return {};
  for (const auto& mistake : mistakes_of_field_times(fields, times)) section.report("fields", mistake);
  return fields;
}

/// One method, or an array of methods.
std::vector<Method> read_methods(const Section& section) {
  if (section.kind("method") == Kind::text) {
    return {section.choice<Method>("method").value_or(Method::quasistatic)};
  }
  auto methods = section.list_of_choices<Method>("method");
  refuse_repeats(section, "method", methods);
  return methods;
}

/// Reads those of these options that a deck gives.
QuasistaticOptions read_quasistatic(const Section& section, QuasistaticOptions options) {
  if (section.has("vary")) options.sampling.tolerance = coarse_tolerance;
  options.sampling.tolerance =
      section.optional_number("tolerance", allowed::accuracy).value_or(options.sampling.tolerance);
  if (section.has("range")) {
    options.range = section.choice<SampledRange>("range").value_or(options.range);
  }
  options.steps_per_decade = static_cast<int>(
      section.optional_integer("steps_per_decade", allowed::steps_per_decade).value_or(options.steps_per_decade));
  if (section.has("linear")) {
    options.linear.method = section.choice<LinearMethod>("linear").value_or(options.linear.method);
  }
  options.linear.tolerance =
      section.optional_number("linear_tolerance", allowed::accuracy).value_or(options.linear.tolerance);
  return options;
}

DynamicOptions read_dynamic(const Section& section) {
  DynamicOptions options;
  if (section.has("formulation")) {
    options.formulation = section.choice<Formulation>("formulation").value_or(options.formulation);
  }
  if (section.has("start")) {
    options.start = section.choice<Start>("start").value_or(options.start);
  }
  options.courant = section.optional_number("courant", allowed::courant).value_or(options.courant);
  if (section.has("ramp")) section.refuse({"ramp_transits"}, "the ramp is given as a time already");
  options.ramp_time = section.optional_quantity("ramp", Dimension::time, allowed::ramp);
  options.ramp_transits = section.optional_number("ramp_transits", allowed::ramp).value_or(options.ramp_transits);
  options.creep_ramp_transits =
      section.optional_number("creep_ramp_transits", allowed::ramp).value_or(options.creep_ramp_transits);
  options.mass_scaling_factors = read_mass_scaling_factors(section);
  options.overlap = section.optional_number("overlap", allowed::overlap).value_or(options.overlap);
  options.reduction_tolerance = section.optional_number("reduction_tolerance", allowed::reduction_tolerance)
                                    .value_or(options.reduction_tolerance);
  return options;
}

bool has_periodic_particles(const Stage& stage) {
  return !stage.fillers.empty() && stage.is_periodic();
}

/// The default boundaries: periodic if a box is periodic, since the other boundaries would cut its particles;
/// displacement if films run along the sides of a box, which allow no other boundary.
std::vector<Boundary> default_boundaries(const std::vector<Stage>& stages) {
  if (std::ranges::any_of(stages, has_periodic_particles)) return {Boundary::periodic};
  if (std::ranges::any_of(stages, &Stage::has_films_along_walls)) return {Boundary::displacement};
  return {Boundary::displacement, Boundary::traction};
}

/// Reads the elements of grains and films: those of the plane or of space.
FilmOptions read_films(const Section& section, const std::vector<Stage>& stages) {
  FilmOptions films;
  const bool is_in_space = !stages.empty() && stages.front().dimensions() == 3;
  if (is_in_space) {
    section.refuse({"face_share"}, "it is of two dimensions; in three, divisions are the elements along an edge");
    films.divisions =
        static_cast<int>(section.optional_integer("divisions", allowed::divisions).value_or(films.divisions));
  } else {
    section.refuse({"divisions"}, "it is of three dimensions; in two, face_share is the length of the elements");
    films.face_share = section.optional_number("face_share", allowed::face_share).value_or(films.face_share);
  }
  const auto layers = section.optional_integer("layers", allowed::layers);
  if (layers) films.layers = static_cast<int>(*layers);
  return films;
}

/// The word for the loads of the whole stiffness.
constexpr std::string_view word_of_stiffness = "stiffness";

/// The words among the loads of a deck; nothing stands for the whole stiffness.
std::vector<std::optional<TestLoad>> read_words_of_loads(const Section& section) {
  if (section.kind("loads") == Kind::text) {
    const auto word = section.text("loads");
    if (word == word_of_stiffness) return {std::nullopt};
    if (word != name_of(TestLoad::isotropic())) {
      section.report("loads", R"(expected "isotropic", "stiffness" or an array, such as ["shear", "bulk"])");
    }
    return {TestLoad::isotropic()};
  }
  std::vector<Choice<std::optional<TestLoad>>> choices(words<TestLoad>.begin(), words<TestLoad>.end());
  choices.emplace_back(word_of_stiffness, std::nullopt);
  return section.list_of_choices<std::optional<TestLoad>>("loads", choices);
}

/// Reads the loads into the tests. Those that the box does not have are reported and left out. The whole stiffness
/// takes the isotropic mean and bulk.
void read_loads(const Section& section, const std::vector<Stage>& stages, Tests& tests) {
  const auto named = read_words_of_loads(section);
  refuse_repeats(section, "loads", named);
  auto& loads = tests.loads;
  loads.clear();
  tests.whole_stiffness = std::ranges::any_of(named, [](const auto& load) { return !load; });
  if (tests.whole_stiffness) loads = {TestLoad::isotropic(), Load::bulk};
  for (const auto& load : named) {
    if (load && std::ranges::find(loads, *load) == loads.end()) loads.push_back(*load);
  }
  if (stages.empty()) return;
  const int dimensions = stages.front().dimensions();
  for (const auto& mistake : mistakes_of_loads(loads, dimensions)) section.report("loads", mistake);
  std::erase_if(loads, [dimensions](TestLoad load) { return !has_test_load(load, dimensions); });
}

}  // namespace

Tests read_tests(const Section& deck, const std::vector<Stage>& stages, const StageDefaults& defaults) {
  const auto section = deck.section("tests");
  Tests tests;
  tests.model = defaults.model;
  if (tests.model == Model::films) {
    tests.quasistatic.sampling.tolerance = coarse_tolerance;
    if (const auto films = section.optional_section("films")) {
      tests.films = read_films(*films, stages);
    }
  } else {
    section.refuse({"films"}, R"(it belongs to model = "films")");
  }
  tests.boundaries = defaults.boundaries.empty() ? default_boundaries(stages) : defaults.boundaries;
  tests.loads = {TestLoad::isotropic()};
  if (section.has("loads")) read_loads(section, stages, tests);
  section.refuse({"bounds"}, R"(it is called boundaries now: "upper" is "displacement", "lower" is "traction" there)");
  if (section.has("boundaries")) {
    tests.boundaries = section.list_of_choices<Boundary>("boundaries");
    refuse_repeats(section, "boundaries", tests.boundaries);
    const bool is_periodic = std::ranges::count(tests.boundaries, Boundary::periodic) == std::ssize(tests.boundaries);
    if (!defaults.boundaries.empty() && is_periodic) {
      section.report("boundaries",
                     R"(packing.walls = "cut" is a window: expected "displacement" or "traction" among them)");
    }
  }
  if (section.has("method")) tests.methods = read_methods(section);
  const auto times = read_times_or_frequencies(section);
  tests.by_frequency = section.has("frequencies");
  if (times) {
    tests.first_time = times->begin;
    tests.last_time = times->end;
  }
  tests.field_times = read_field_times(section, times);
  tests.lists_field_times = section.has("fields") && section.kind("fields") != Kind::text;
  tests.points_per_decade =
      static_cast<int>(section.optional_integer("points_per_decade", allowed::points_per_decade).value_or(20));
  if (section.has("accuracy")) tests.accuracy = section.fraction("accuracy");
  tests.fit_tolerance = section.optional_number("fit_tolerance", allowed::fit_tolerance).value_or(tests.fit_tolerance);
  if (const auto quasistatic = section.optional_section("quasistatic")) {
    tests.quasistatic = read_quasistatic(*quasistatic, tests.quasistatic);
    tests.varied = read_varied_materials(*quasistatic, stages);
  }
  if (const auto dynamic = section.optional_section("dynamic")) tests.dynamic = read_dynamic(*dynamic);
  if (section.has("solver")) {
    tests.quasistatic.solver = section.choice<Solver>("solver").value_or(tests.quasistatic.solver);
  }
  if (section.has("volumetric")) {
    tests.volumetric = section.choice<Volumetric>("volumetric").value_or(tests.volumetric);
  }
  return tests;
}

std::optional<Mixing> read_mixing(const Section& deck) {
  const auto section = deck.optional_section("tests");
  return section && section->has("mixing") ? section->choice<Mixing>("mixing") : std::nullopt;
}

}  // namespace breccia
