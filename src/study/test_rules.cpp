#include "study/test_rules.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "breccia/virtual_test/curve.hpp"

#include "io/units.hpp"
#include "study/limits.hpp"

namespace breccia {
namespace {

bool uses(const Tests& tests, Method method) {
  return std::ranges::find(tests.methods, method) != tests.methods.end();
}

/// Mistakes where films run along walls under another boundary than displacement. Such a film makes the lower bound
/// useless: it is so soft that the box moves in it as a whole.
std::vector<std::string> films_along_walls(const Study& study) {
  const auto is_other = [](Boundary boundary) { return boundary != Boundary::displacement; };
  if (std::ranges::none_of(study.tests.boundaries, is_other)) return {};
  std::vector<std::string> mistakes;
  for (const auto& stage : study.stages) {
    if (!stage.has_films_along_walls() || model_of(study.tests, stage) == Model::films) continue;
    mistakes.push_back(
        fmt::format("the grains of stage {} have films along the walls: expected the boundary \"{}\" "
                    "alone, or packing.walls = \"cut\" or false",
                    stage.name, name_of(Boundary::displacement)));
  }
  return mistakes;
}

/// The boundaries that a box expects where it may not be cut; nothing where the tests have no others.
std::optional<std::string> expected_boundaries(const Tests& tests, const Stage& stage) {
  const bool is_periodic = stage.is_periodic();
  const auto fits = [is_periodic](Boundary boundary) { return (boundary == Boundary::periodic) == is_periodic; };
  if (std::ranges::all_of(tests.boundaries, fits)) return std::nullopt;
  return is_periodic ? R"(expected the boundary "periodic")"
                     : R"(expected the boundaries "displacement" and "traction")";
}

/// The stages with bonds that are not computed as grains and films, a line each.
std::vector<std::string> bonds_without_films(const Study& study) {
  std::vector<std::string> mistakes;
  for (const auto& stage : study.stages) {
    if (!stage.bonds || model_of(study.tests, stage) == Model::films) continue;
    mistakes.push_back(
        fmt::format(R"(bonds of stage {}: films alone can be debonded or on springs: expected tests.model = "films")"
                    R"( and grains, packing.method = "laguerre")",
                    stage.name));
  }
  return mistakes;
}

/// Whether the tests vary a material of fillers or coatings.
bool varies_fillers(const Study& study) {
  const auto is_varied = [&study](const Material& material) {
    return std::ranges::find(study.tests.varied, material.name, &VariedMaterial::name) != study.tests.varied.end();
  };
  return std::ranges::any_of(study.stages, [&](const Stage& stage) {
    return std::ranges::any_of(stage.fillers, [&](const Filler& filler) {
      return is_varied(filler.material) || (filler.coating && is_varied(filler.coating->material));
    });
  });
}

/// The stages of crystals that are in images or tested by the dynamic method, or whose moduli vary, a line each.
std::vector<std::string> misplaced_crystals(const Study& study) {
  std::vector<std::string> mistakes;
  for (const auto& stage : study.stages) {
    for (const auto& filler : stage.fillers) {
      if (!filler.crystal) continue;
      const auto part = fmt::format("crystals of stage {}, {}: ", stage.name, filler.material.name);
      const auto refuse = [&](std::string_view reason) {
        mistakes.push_back(
            fmt::format(R"({}{}, or a material with their isotropic means, bulk = "{}" and shear = "{}")", part, reason,
                        readable(filler.material.bulk.unrelaxed(), Dimension::pressure),
                        readable(filler.material.shear.unrelaxed(), Dimension::pressure)));
      };
      if (stage.has_image()) refuse("pixels do not distinguish particles: expected particles or grains");
      if (uses(study.tests, Method::dynamic)) {
        refuse(R"(the dynamic method knows isotropic materials alone: expected tests.method = "quasistatic")");
      }
      if (std::ranges::find(study.tests.varied, filler.material.name, &VariedMaterial::name) !=
          study.tests.varied.end()) {
        mistakes.push_back(part + "expected moduli that do not vary");
      }
    }
  }
  return mistakes;
}

/// The requests of the tests that the model of films does not support in one stage of grains, a line each.
std::vector<std::string> lacking_in_films(const Tests& tests, const Stage& stage) {
  std::vector<std::string> mistakes;
  const auto lacks = [&](const std::string& what) {
    mistakes.push_back(fmt::format("model \"films\", stage {}: {}", stage.name, what));
  };
  const auto& grains = stage.fillers.front().material;
  if (!grains.shear.is_elastic() || !grains.bulk.is_elastic()) lacks("expected grains that are elastic");
  if (is_void(grains)) lacks(R"(expected solid grains; with model = "cells" they may be voids)");
  if (const auto* method = stage.packed_by<LaguerrePacking<3>>(); method != nullptr && !method->is_random()) {
    if (!method->film_shares.empty()) {
      lacks("in three dimensions films have nearly one thickness: expected sites without film_share");
    }
    if (method->sites.size() < 2) lacks("in three dimensions: expected two sites and more");
  }
  if (stage.dimensions() == 3 && !stage.is_periodic()) {
    lacks("in three dimensions: expected a periodic box (packing.walls = false)");
    return mistakes;
  }
  if (stage.has_films_along_walls()) {
    lacks(R"(expected packing.walls = "cut" or false; no film of this model runs along a wall)");
  }
  if (const auto expected = expected_boundaries(tests, stage)) {
    const auto other_box = stage.dimensions() == 3 ? ""
                           : stage.is_periodic()   ? R"(, or packing.walls = "cut")"
                                                   : ", or packing.walls = false";
    lacks(*expected + other_box);
  }
  if (!stage.coarser_cells.empty()) lacks("expected one number of cells, that of the labels, or none");
  if (stage.bonds && !stage.is_periodic()) {
    lacks("films of a window are all bonded: expected no bonds, or packing.walls = false");
  }
  if (stage.bonds && tests.films.layers && stage.bonds->kind != Debonding::open) {
    lacks(R"(films that are resolved by layers are debonded as open gaps alone: expected bonds.kind = "open")");
  }
  return mistakes;
}

/// The requests that the model of films, which is quasi-static and for grains, does not support, a line each.
std::vector<std::string> lacking_in_films(const Study& study) {
  const auto& tests = study.tests;
  if (tests.model == Model::cells) return {};
  std::vector<std::string> mistakes;
  bool has_grains = false;
  for (const auto& stage : study.stages) {
    if (model_of(tests, stage) != Model::films) continue;
    has_grains = true;
    std::ranges::move(lacking_in_films(tests, stage), std::back_inserter(mistakes));
  }
  if (!has_grains)
    mistakes.emplace_back(R"(model "films" is for grains: expected a stage with packing.method "laguerre")");
  if (uses(tests, Method::dynamic))
    mistakes.emplace_back(R"(model "films" has no inertia: expected method "quasistatic")");
  if (varies_fillers(study))
    mistakes.emplace_back(R"(model "films" cannot vary other moduli than those of the matrix)");
  if (has_grains && tests.lists_field_times && tests.films.layers) {
    mistakes.emplace_back(
        "films.layers: films that are resolved leave no fields: expected fields = \"none\", or thin films");
  }
  return mistakes;
}

/// A mistake where moduli vary without a reduced basis, since no other solver samples over moduli.
std::optional<std::string> vary_without_samples(const Tests& tests) {
  if (tests.varied.empty()) return std::nullopt;
  const auto takes_one_value = [](std::string_view wanted, std::string_view present) {
    return fmt::format("quasistatic.vary is for {}; \"{}\" takes one value of each modulus", wanted, present);
  };
  if (!uses(tests, Method::quasistatic)) return takes_one_value("method \"quasistatic\"", name_of(Method::dynamic));
  if (tests.quasistatic.solver == Solver::reduced) return std::nullopt;
  return takes_one_value("solver \"reduced\"", name_of(Solver::stepping));
}

/// A mistake where mixed cells do not have averaged volumetric strains.
std::optional<std::string> mixing_of_points(const Tests& tests) {
  if (!has_mixed_cells(tests.mixing) || tests.volumetric == Volumetric::averaged) return std::nullopt;
  return fmt::format(R"(mixing "{}" takes the volumetric strains "{}": expected these, or mixing "{}")",
                     name_of(tests.mixing), name_of(Volumetric::averaged), name_of(Mixing::points));
}

/// Whether particles of a stage in three dimensions may be others than spheres.
bool may_have_ellipsoids(const Stage& stage) {
  const auto* listed = stage.packed_by<ExplicitPacking<3>>();
  return (listed != nullptr && std::holds_alternative<std::vector<Ellipsoid>>(listed->particles)) ||
         std::ranges::any_of(stage.fillers, [](const Filler& filler) { return filler.shape.has_value(); });
}

/// What cells with flow through gaps expect of a stage, beyond what it has.
std::vector<std::string> expected_by_flow(const Tests& tests, const Stage& stage) {
  std::vector<std::string> expected;
  if (stage.dimensions() == 3) {
    const auto is_periodic = [](Boundary boundary) { return boundary == Boundary::periodic; };
    if (stage.has_grains() || stage.has_image() || may_have_ellipsoids(stage)) {
      expected.emplace_back("in three dimensions: expected spheres");
    }
    if (stage.has_crystals()) expected.emplace_back("in three dimensions: expected isotropic fillers, not crystals");
    if (!stage.fillers.empty() && !stage.is_periodic()) {
      expected.emplace_back("in three dimensions: expected a periodic box (packing.walls = false)");
    }
    if (!stage.fillers.empty() && !std::ranges::all_of(tests.boundaries, is_periodic)) {
      expected.emplace_back(R"(in three dimensions: expected tests.boundaries = ["periodic"])");
    }
    return expected;
  }
  if (stage.has_image()) expected.emplace_back("expected particles or grains, not an image");
  if (auto boundaries = expected_boundaries(tests, stage); boundaries && !stage.fillers.empty()) {
    expected.push_back(*std::move(boundaries));
  }
  if (stage.has_cut_grains()) expected.emplace_back(R"(expected packing.walls other than "cut")");
  return expected;
}

/// Whether series are fits, for which there may be too few times. All series are fits, except those of the reduced
/// solver on a single grid or with mixed cells, where the finest grid gives the result.
bool has_fits(const Study& study) {
  const bool is_extrapolated = study.tests.mixing == Mixing::points;
  return uses(study.tests, Method::dynamic) || study.tests.quasistatic.solver == Solver::stepping ||
         std::ranges::any_of(study.stages, [is_extrapolated](const Stage& stage) {
           return (is_extrapolated && !stage.coarser_cells.empty()) ||
                  std::holds_alternative<EarlierStage>(stage.matrix);
         });
}

/// A mistake where there are too few times for fits; nothing where their number is not known because of another
/// mistake.
std::optional<std::string> too_few_times(const Study& study) {
  constexpr std::size_t fewest = 3;
  const auto& tests = study.tests;
  const bool are_known = tests.first_time > 0.0 && tests.last_time > tests.first_time &&
                         std::isfinite(tests.last_time) && accepts(allowed::points_per_decade, tests.points_per_decade);
  if (!are_known || !has_fits(study)) return std::nullopt;
  const auto times = logarithmic_times({tests.first_time, tests.last_time}, tests.points_per_decade).size();
  if (times >= fewest) return std::nullopt;
  return fmt::format(
      "times and points_per_decade give {} times, of which no series can be fitted; expected at least {}", times,
      fewest);
}

/// Why the whole stiffness that the tests ask for cannot be found; nothing where it can.
std::optional<std::string> obstacle_to_stiffness(const Tests& tests) {
  if (!tests.whole_stiffness) return std::nullopt;
  if (!uses(tests, Method::quasistatic)) {
    return R"(loads "stiffness" is for method "quasistatic")";
  }
  for (const auto& load : {TestLoad::isotropic(), TestLoad(Load::bulk)}) {
    if (std::ranges::find(tests.loads, load) == tests.loads.end()) {
      return fmt::format(R"(loads "stiffness" takes "{}": expected it among the loads)", name_of(load));
    }
  }
  const auto is_traction = [](Boundary boundary) { return boundary == Boundary::traction; };
  if (!std::ranges::all_of(tests.boundaries, is_traction)) return std::nullopt;
  return R"(loads "stiffness" is for boundaries that prescribe strains: expected "periodic" or "displacement")";
}

}  // namespace

bool is_rising(const std::vector<double>& values) {
  return std::ranges::is_sorted(values, std::ranges::less_equal());
}

std::vector<std::string> mistakes_of_field_times(const std::vector<double>& field_times, const TimeWindow& times) {
  std::vector<std::string> mistakes;
  if (!is_rising(field_times)) mistakes.emplace_back("expected rising times");
  const auto is_within = [&times](double time) { return time >= times.begin && time <= times.end; };
  const auto outside = std::ranges::find_if_not(field_times, is_within);
  if (outside != field_times.end()) {
    mistakes.push_back(fmt::format("expected times within those of the tests, {} to {}, got {}",
                                   readable(times.begin, Dimension::time), readable(times.end, Dimension::time),
                                   readable(*outside, Dimension::time)));
  }
  return mistakes;
}

Model model_of(const Tests& tests, const Stage& stage) {
  const bool has_grains = stage.has_grains() && !stage.fillers.empty();
  return has_grains ? tests.model : Model::cells;
}

std::vector<std::string> mistakes_of_loads(const std::vector<TestLoad>& loads, int dimensions) {
  std::vector<std::string> in_the_plane;
  for (const auto& [word, load] : words<TestLoad>) {
    if (has_test_load(load, 2)) in_the_plane.push_back(fmt::format("\"{}\"", word));
  }
  std::vector<std::string> mistakes;
  for (const auto load : loads) {
    if (has_test_load(load, dimensions)) continue;
    mistakes.push_back(fmt::format("the load \"{}\" is one of three dimensions; a box of two has {}", name_of(load),
                                   fmt::join(in_the_plane, ", ")));
  }
  return mistakes;
}

bool has_fields(const Tests& tests, const Stage& stage) {
  if (tests.field_times.empty()) return false;
  return model_of(tests, stage) != Model::films || !tests.films.layers;
}

std::vector<std::string> obstacles_to_flow(const Study& study) {
  const auto& tests = study.tests;
  std::vector<std::string> obstacles;
  for (const auto& stage : study.stages) {
    if (model_of(tests, stage) == Model::films) continue;
    for (const auto& expected : expected_by_flow(tests, stage)) {
      obstacles.push_back(fmt::format("stage {}: {}", stage.name, expected));
    }
  }
  if (uses(tests, Method::dynamic)) {
    obstacles.emplace_back(R"(expected method "quasistatic", since the flow has no inertia)");
  }
  if (varies_fillers(study)) {
    obstacles.emplace_back("expected no quasistatic.vary of other moduli than those of the matrix");
  }
  return obstacles;
}

Mixing default_mixing(const Study& study) {
  if (study.tests.volumetric == Volumetric::standard) return Mixing::points;
  // In space flow takes many times the time, so that a deck has to ask for it.
  if (!study.stages.empty() && study.stages.front().dimensions() == 3) return Mixing::series;
  const auto is_of_cells = [&study](const Stage& stage) { return model_of(study.tests, stage) == Model::cells; };
  const bool has_cells = std::ranges::any_of(study.stages, is_of_cells);
  return has_cells && obstacles_to_flow(study).empty() ? Mixing::flow : Mixing::series;
}

std::vector<std::string> contradictions(const Study& study) {
  auto mistakes = films_along_walls(study);
  std::ranges::move(bonds_without_films(study), std::back_inserter(mistakes));
  std::ranges::move(misplaced_crystals(study), std::back_inserter(mistakes));
  std::ranges::move(lacking_in_films(study), std::back_inserter(mistakes));
  if (!study.stages.empty()) {
    std::ranges::move(mistakes_of_loads(study.tests.loads, study.stages.front().dimensions()),
                      std::back_inserter(mistakes));
  }
  if (auto obstacle = obstacle_to_stiffness(study.tests)) mistakes.push_back(*std::move(obstacle));
  if (study.tests.mixing == Mixing::flow) {
    for (const auto& obstacle : obstacles_to_flow(study)) {
      mistakes.push_back(
          fmt::format(R"(mixing "{}": {}, or mixing "{}")", name_of(Mixing::flow), obstacle, name_of(Mixing::series)));
    }
  }
  if (auto mistake = mixing_of_points(study.tests)) mistakes.push_back(*std::move(mistake));
  if (auto mistake = vary_without_samples(study.tests)) mistakes.push_back(*std::move(mistake));
  if (auto mistake = too_few_times(study)) mistakes.push_back(*std::move(mistake));
  return mistakes;
}

}  // namespace breccia
