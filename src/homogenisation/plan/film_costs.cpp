#include "homogenisation/plan/film_costs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "breccia/microstructure/draw_diameters.hpp"

#include "films/solver/full_factors_limit.hpp"
#include "homogenisation/plan/expected_snapshots.hpp"
#include "homogenisation/plan/measured_costs.hpp"
#include "homogenisation/run/named_errors.hpp"
#include "homogenisation/run/test_requests.hpp"
#include "study/chain.hpp"
#include "study/filler_sizes.hpp"
#include "study/test_rules.hpp"

namespace breccia {
namespace {

/// Areas of the cells of a stage, in space volumes, scaled so that they fill the unit box; the cells of listed sites
/// have equal ones here.
template <int dim>
std::vector<double> shares_of_cells(const Stage& stage) {
  const auto& method = *stage.packed_by<LaguerrePacking<dim>>();
  if (!method.is_random()) {
    std::vector<double> equal(method.sites.size(), 1.0 / static_cast<double>(method.sites.size()));
    return equal;
  }
  const auto& filler = stage.fillers.front();
  const auto distribution = distribution_of(filler);
  constexpr double whole_box = 1.0 - 1e-12;
  auto shares = distribution ? draw_diameters<dim>(*distribution, whole_box, stage.side)
                             : std::get<ListedSizes>(filler.sizes.value()).diameters;
  double sum = 0.0;
  for (double& share : shares) sum += share = times_power<dim>(1.0, share);
  for (double& share : shares) share /= sum;
  return shares;
}

/// Thickness of the films between hexagons of these shares, over the side of the box, where the hexagons without films
/// fill a fraction of the box. A hexagon of the area a and the apothem r keeps a (1 - t / 2r)^2, a = 2 sqrt(3) r^2; the
/// sum over all is quadratic in t.
double film_between_hexagons(const std::vector<double>& shares, double fraction) {
  const double of_apothem = 2.0 * std::numbers::sqrt3;
  double apothems = 0.0;
  for (const double share : shares) apothems += std::sqrt(share / of_apothem);
  const double half = 0.5 * apothems, square = 0.25 * static_cast<double>(shares.size());
  const double films = (1.0 - fraction) / of_apothem;  // films = 2 half t - square t^2
  return films / (half + std::sqrt(std::max(0.0, half * half - square * films)));
}

constexpr double side_of_hexagon = 0.62;  ///< of the unit area

/// Number of elements along a film, with so many layers, between hexagons of the unit area (graded_divisions).
double elements_along(const Tests& tests, double film) {
  constexpr double growth = 1.5, grading = 0.7;
  const double layers = *tests.films.layers, turn = 2.0 * std::numbers::pi;
  const double first = film * (1.0 / layers - grading / turn * std::sin(turn / layers));
  const double half = 0.5 * std::max(film, side_of_hexagon - film / std::numbers::sqrt3);
  const double longest = std::max(first, tests.films.face_share);
  const double in_growing = std::min(half, 2.0 * (longest - first));
  return 1.0 + 2.0 * (std::log1p(0.5 * in_growing / first) / std::log(growth) + (half - in_growing) / longest);
}

/// The unknowns of a polyhedron with 14 faces, in their mean, and of its share of films, channels and junctions. Most
/// grow with the triangles of the faces.
double unknowns_of_polyhedron(const FilmOptions& films) {
  constexpr double star = 540.0, shell = 864.0, thin_films = 330.0, layer = 216.0, pressures = 18.0;
  const double divisions = films.divisions, triangles = divisions * divisions;
  const double solid = triangles * (star + shell * std::max(0.0, divisions - 2.0));
  if (!films.layers) return solid + triangles * thin_films;
  const double layers = *films.layers, of_channels = 75.0 * layers * layers * (1.0 + 0.75 * divisions);
  return solid + triangles * (layer * (2.0 * layers - 1.0) + pressures * (layers + 1.0)) + of_channels;
}

double unknowns_of_grain(const Tests& tests, double film) {
  if (!tests.films.layers) {
    // Each element along a face adds its part of the rings of triangles inside the grain.
    constexpr double of_elements = 58.0;
    return of_elements / tests.films.face_share;
  }
  // Three films and two junctions for each grain: nine nodes and a pressure for each quadrilateral, with those shared
  // by others; and the triangles of the grain, of which there are as many as elements along its faces.
  constexpr double of_layer = 27.0, of_junction_rows = 54.0, of_grain = 56.0;
  const double layers = *tests.films.layers;
  return of_junction_rows * layers * layers + elements_along(tests, film) * (of_layer * layers + of_grain);
}

/// The jumps across springs for each grain if all films have them: at the nodes of three films of the plane, each as
/// long as the side of a hexagon of the unit area, or of seven faces, fans of triangles between five corners or so.
double jumps_of_grain(const FilmOptions& films, int dimensions) {
  if (dimensions == 2) return 3.0 * 2.0 * (1.0 + 2.0 * side_of_hexagon / films.face_share);
  constexpr double corners = 36.0 / 7.0;
  const double divisions = films.divisions;
  return 7.0 * 3.0 * (1.0 + corners * divisions * (2.0 * divisions + 1.0));
}

bool has_springs(const Stage& stage) {
  return stage.bonds && stage.bonds->kind == Debonding::spring;
}

/// Memory of matrices and factors in the plane [B]; the solver keeps factors in files if they took more than some size.
double system_in_the_plane(double unknowns) {
  namespace costs = measured_costs;
  const bool are_in_files = costs::film_factors * unknowns > costs::most_factors;
  return unknowns * (are_in_files ? costs::films_in_files : costs::films_in_memory);
}

/// Whether the factors of so many unknowns in space are compressed.
bool has_compressed_factors(double unknowns) {
  return unknowns > static_cast<double>(films::full_factors_in_space);
}

/// Memory of matrices and factors in space [B], where resolved films have more entries a row.
double system_in_space(const Tests& tests, double unknowns) {
  namespace costs = measured_costs;
  if (has_compressed_factors(unknowns)) return costs::compressed_films * unknowns;
  const double of_layers = tests.films.layers ? costs::memory_of_resolved_films_in_space : 1.0;
  return of_layers * costs::films_in_space * std::pow(unknowns, costs::power_of_films_in_space);
}

}  // namespace

FilmedGrains expected_grains(const Stage& stage) {
  const bool is_in_space = stage.dimensions() == 3;
  const auto shares =
      name_errors(stage.name, [&] { return is_in_space ? shares_of_cells<3>(stage) : shares_of_cells<2>(stage); });
  const auto count = static_cast<double>(shares.size());
  const double on_springs = has_springs(stage) ? stage.bonds->debonded : 0.0;
  if (is_in_space) return {.count = count, .dimensions = 3, .on_springs = on_springs};
  const auto& asked = stage.packed_by<LaguerrePacking<2>>()->film;
  const double film =
      asked ? *asked / stage.side : film_between_hexagons(shares, stage.fillers.front().fraction.value_or(1.0));
  return {.count = count, .film = film * std::sqrt(count), .on_springs = on_springs};
}

FilmedGrains placed_grains(const Stage& stage, const GrainStatistics& grains) {
  const auto count = static_cast<double>(grains.count);
  return {.count = count,
          .film = grains.film / stage.side * std::sqrt(count),
          .dimensions = stage.dimensions(),
          .on_springs = has_springs(stage) ? grains.debonded : 0.0};
}

double film_unknowns(const Tests& tests, const FilmedGrains& grains) {
  const bool is_in_space = grains.dimensions == 3;
  const double of_jumps = grains.on_springs * jumps_of_grain(tests.films, grains.dimensions);
  return grains.count *
         (of_jumps + (is_in_space ? unknowns_of_polyhedron(tests.films) : unknowns_of_grain(tests, grains.film)));
}

double film_memory(const Study& study, const Stage& stage, const FilmedGrains& grains) {
  namespace costs = measured_costs;
  const double unknowns = film_unknowns(study.tests, grains);
  const auto loads = static_cast<double>(most_solved_loads(study, stage));
  const double system = grains.dimensions == 3 ? system_in_space(study.tests, unknowns) : system_in_the_plane(unknowns);
  // Displacements and two forces for each snapshot, or a vector for each term in fine and in coarse steps.
  const bool is_reduced = study.tests.quasistatic.solver == Solver::reduced;
  const auto matrix = expected_matrix(study, stage);
  const auto terms = static_cast<double>(matrix.shear.terms().size() + matrix.bulk.terms().size());
  const double vectors = is_reduced ? 3.0 * expected_snapshots(study, stage) : 2.0 * terms;
  const double solution = costs::program + system + unknowns * sizeof(double) * loads * vectors;
  // Fields are written when the factors are gone.
  if (!has_fields(study.tests, stage)) return solution;
  const auto times = static_cast<double>(study.tests.field_times.size());
  const double divisions = study.tests.films.divisions;
  const double of_time = grains.dimensions == 3 ? costs::fields_of_polyhedron_and_time * divisions * divisions
                                                : costs::fields_of_grain_and_time;
  return std::max(solution, costs::field_files + (costs::fields_of_grain + of_time * times) * grains.count);
}

double film_time(const Study& study, const Stage& stage, const FilmedGrains& grains) {
  namespace costs = measured_costs;
  const double unknowns = film_unknowns(study.tests, grains);
  const bool is_reduced = study.tests.quasistatic.solver == Solver::reduced;
  // Each step has factors of its own.
  const double solutions = is_reduced ? expected_snapshots(study, stage) : expected_steps(study.tests);
  if (grains.dimensions == 3 && has_compressed_factors(unknowns)) {
    const auto loads = static_cast<double>(most_solved_loads(study, stage));
    return solutions * unknowns * (costs::compressed_snapshot + loads * costs::solution_by_compressed);
  }
  if (grains.dimensions == 3) {
    const double of_layers = study.tests.films.layers ? costs::time_of_resolved_films_in_space : 1.0;
    const double size = unknowns / costs::unknowns_of_space_snapshot;
    return solutions * of_layers * std::pow(size, costs::power_of_space_snapshot);
  }
  const double size = std::max(1.0, unknowns / costs::unknowns_of_film_snapshot);
  return solutions * costs::film_snapshot * unknowns * std::pow(size, costs::power_of_film_snapshot);
}

}  // namespace breccia
