// Example 9: what the model of thin films errs, against films that are resolved by layers of elements, for one random
// tessellation. Without arguments a small one; the table of docs/verification.md has others.
//
//   ex09_resolved_films [SEED GRAINS RATIO FILM BOUNDARY LAYERS [FACE_SHARE]]
//
// RATIO is that of the largest and the smallest of the grains' diameters, between which each is larger by one factor;
// FILM the thickness of the films over the smallest diameter; BOUNDARY displacement, traction or periodic.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/films/film_moduli.hpp"
#include "breccia/microstructure/random_sites.hpp"
#include "breccia/words.hpp"

#include "argument_reader.hpp"

using breccia::Boundary;
using breccia::Load;

namespace {

struct Choice {
  std::uint64_t seed = 1;
  int grains = 12;
  double ratio = 2.0;
  double film = 0.06;  // over the smallest diameter
  Boundary boundary = Boundary::periodic;
  int layers = 2;
  double face_share = 0.2;
};

Boundary boundary_of(const std::string& argument, std::vector<std::string>& mistakes) {
  const auto found = breccia::value_named<Boundary>(argument);
  if (!found) {
    mistakes.push_back(fmt::format("BOUNDARY: expected displacement, traction or periodic, got \"{}\"", argument));
  }
  return found.value_or(Boundary::periodic);
}

// Throws InputError with all that is wrong with the arguments.
Choice choice_of(const std::vector<std::string>& arguments) {
  Choice choice;
  if (arguments.empty()) return choice;
  if (arguments.size() != 6 && arguments.size() != 7) {
    throw breccia::InputError(fmt::format(
        "expected no argument, or SEED GRAINS RATIO FILM BOUNDARY LAYERS [FACE_SHARE]; got {}", arguments.size()));
  }
  examples::ArgumentReader read;
  choice.seed = read.number(arguments[0], "SEED", std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max());
  choice.grains = read.number(arguments[1], "GRAINS", 1, 100000);
  choice.ratio = read.number(arguments[2], "RATIO", 1.0, 1e3);
  choice.film = read.number(arguments[3], "FILM", 1e-4, 1.0);
  choice.boundary = boundary_of(arguments[4], read.mistakes);
  choice.layers = read.number(arguments[5], "LAYERS", 1, 16);
  if (arguments.size() > 6) choice.face_share = read.number(arguments[6], "FACE_SHARE", 0.005, 1.0);
  if (!read.mistakes.empty()) throw breccia::InputError(fmt::format("{}", fmt::join(read.mistakes, "\n")));
  return choice;
}

// Grains in the unit square, whose areas are those of discs of the chosen diameters, parted by films of one thickness.
breccia::FilmProblem<2> problem_of(const Choice& choice) {
  breccia::RandomTessellationRequest request;
  request.side = 1.0;
  request.walls = choice.boundary == Boundary::periodic ? breccia::Walls::periodic : breccia::Walls::hard;
  request.seed = choice.seed;
  double area = 0.0;
  for (int i = 0; i < choice.grains; ++i) {
    request.diameters.push_back(std::pow(choice.ratio, 1.0 * i / std::max(1, choice.grains - 1)));
    area += 0.25 * std::numbers::pi * request.diameters.back() * request.diameters.back();
  }
  return {.tessellation = breccia::Tessellation<2>(breccia::random_sites<2>(request)),
          .thickness = choice.film / std::sqrt(area),
          .grain = {.bulk = 13.4e9, .shear = 5.84e9},
          .boundary = choice.boundary,
          .elements = {.face_share = choice.face_share}};
}

// Length of the films shorter than five times their thickness over that of all films: there films are not thin.
double share_of_short_films(const breccia::FilmProblem<2>& problem) {
  double all = 0.0, in_short_films = 0.0;
  for (std::size_t site = 0; site < problem.tessellation.size(); ++site) {
    const auto& cell = problem.tessellation.cell(site);
    const auto lengths = breccia::face_measures(cell);
    for (std::size_t face = 0; face < lengths.size(); ++face) {
      if (!breccia::Tessellation<2>::neighbour(cell.half_spaces()[face])) continue;
      all += lengths[face];
      if (lengths[face] < 5.0 * problem.thickness) in_short_films += lengths[face];
    }
  }
  return in_short_films / all;
}

}  // namespace

int main(int count, char** values) try {
  const auto choice = choice_of({values + 1, values + count});
  auto problem = problem_of(choice);
  fmt::print("{} grains that fill {:.2f} % of the box, {} boundary, {} layers\n", choice.grains,
             100.0 * breccia::grain_fraction(problem.tessellation, problem.thickness), name_of(choice.boundary),
             choice.layers);
  fmt::print("{:.0f} % of the length of the films is in films shorter than five times their thickness\n\n",
             100.0 * share_of_short_films(problem));

  // The binder: K = 3.6 GPa, and shear moduli from stiff to soft [Pa].
  std::vector<breccia::Moduli> binders;
  for (const double shear : {2e9, 3e8, 5e7, 1e7, 2e6, 5e5}) binders.push_back({3.6e9, shear});
  const std::array loads = {Load::shear, Load::diagonal_shear, Load::bulk};
  const auto thin = breccia::film_moduli(problem, binders, loads);
  problem.layers = choice.layers;
  const auto resolved = breccia::film_moduli(problem, binders, loads);

  double largest = 0.0;
  fmt::print("{:>12}", "binder [MPa]");
  for (const auto load : loads) fmt::print("  {:>26}", fmt::format("{} [MPa]", name_of(load)));
  fmt::print("\n");
  for (std::size_t b = 0; b < binders.size(); ++b) {
    fmt::print("{:12g}", binders[b].shear / 1e6);
    for (std::size_t l = 0; l < loads.size(); ++l) {
      const double error = thin[b][l] / resolved[b][l] - 1.0;
      largest = std::max(largest, std::abs(error));
      fmt::print("  {:9.2f}{:9.2f} {:+6.2f} %", resolved[b][l] / 1e6, thin[b][l] / 1e6, 100.0 * error);
    }
    fmt::print("\n");
  }
  fmt::print("\nresolved, thin films, error of thin films: at most {:.2f} %\n", 100.0 * largest);
  return 0;
} catch (const breccia::Error& error) {
  fmt::print(stderr, "{}\n", error.what());
  return static_cast<int>(error.exit_code());
}
