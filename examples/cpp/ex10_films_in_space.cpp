// Example 10: what thin films in three dimensions err, against films that are resolved by two layers of tetrahedra, for
// one random tessellation of polyhedral grains.
//
//   ex10_films_in_space [SEED GRAINS RATIO FRACTION FINEST]
//
// RATIO is that of the largest and the smallest of the grains' diameters, between which each is larger by the same
// amount; FRACTION is that of the grains; FINEST the number of elements along an edge of the finer one of two resolved
// meshes, from which the limit of short elements is found: their error falls with the square of that number.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/films/film_moduli.hpp"
#include "breccia/microstructure/random_sites.hpp"

#include "argument_reader.hpp"

using breccia::Load;

namespace {

struct Choice {
  std::uint64_t seed = 1;
  int grains = 2;
  double ratio = 1.0;
  double fraction = 0.93;
  int finest = 2;
};

// Throws InputError with all that is wrong with the arguments.
Choice choice_of(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return {};
  if (arguments.size() != 5) {
    throw breccia::InputError(
        fmt::format("expected no argument, or SEED GRAINS RATIO FRACTION FINEST; got {}", arguments.size()));
  }
  examples::ArgumentReader read;
  const Choice choice = {.seed = read.number(arguments[0], "SEED", std::uint64_t{0}, std::uint64_t{1} << 32U),
                         .grains = read.number(arguments[1], "GRAINS", 2, 1000),
                         .ratio = read.number(arguments[2], "RATIO", 1.0, 100.0),
                         .fraction = read.number(arguments[3], "FRACTION", 0.5, 0.999),
                         .finest = read.number(arguments[4], "FINEST", 2, 8)};
  if (!read.mistakes.empty()) throw breccia::InputError(fmt::format("{}", fmt::join(read.mistakes, "\n")));
  return choice;
}

// Grains that fill a periodic cube, whose volumes are those of balls of the chosen diameters.
breccia::FilmProblem<3> problem_of(const Choice& choice) {
  breccia::RandomTessellationRequest request;
  request.side = 1.0;
  request.seed = choice.seed;
  for (int i = 0; i < choice.grains; ++i) {
    request.diameters.push_back(1.0 + (choice.ratio - 1.0) * i / (choice.grains - 1));
  }
  const breccia::Tessellation<3> tessellation(breccia::random_sites<3>(request));
  return {.tessellation = tessellation,
          .thickness = breccia::film_thickness(tessellation, choice.fraction),
          .grain = {.bulk = 13.4e9, .shear = 5.84e9}};
}

// Mean shear modulus [Pa], by binder.
std::vector<double> mean_shears(breccia::FilmProblem<3> problem, const std::vector<breccia::Moduli>& binders,
                                int divisions, std::optional<int> layers) {
  constexpr std::array loads = {Load::shear, Load::shear_yz, Load::shear_zx, Load::diagonal_shear, Load::axial_shear};
  problem.elements.divisions = divisions;
  problem.layers = layers;
  std::vector<double> means;
  for (const auto& of_loads : breccia::film_moduli(problem, binders, loads)) {
    double sum = 0.0;
    for (const double modulus : of_loads) sum += modulus;
    means.push_back(sum / static_cast<double>(loads.size()));
  }
  return means;
}

}  // namespace

int main(int count, char** values) try {
  const auto choice = choice_of({values + 1, values + count});
  const auto problem = problem_of(choice);
  fmt::print("{} grains that fill {:.2f} % of a periodic cube\n\n", choice.grains, 100.0 * choice.fraction);
  // The binder: K = 3.6 GPa, and shear moduli from stiff to soft [Pa].
  std::vector<breccia::Moduli> binders;
  for (const double shear : {1e9, 1e8, 1e7, 1e6, 1e5}) binders.push_back({3.6e9, shear});

  constexpr int layers = 2;
  const int coarse = choice.finest - 1, fine = choice.finest;
  const auto of_coarse = mean_shears(problem, binders, coarse, layers);
  const auto of_fine = mean_shears(problem, binders, fine, layers);
  const double share = 1.0 * coarse * coarse / (fine * fine - coarse * coarse);
  std::vector<std::vector<double>> thin;
  for (const int divisions : {1, 2}) thin.push_back(mean_shears(problem, binders, divisions, {}));

  fmt::print(
      "mean shear modulus [MPa] of resolved films with {} and {} elements an edge and in the limit of many, and the\n"
      "error of thin films with 1 and 2 elements an edge\n\n",
      coarse, fine);
  fmt::print("{:>12}{:>10}{:>10}{:>10}{:>9}{:>9}\n", "binder [MPa]", coarse, fine, "limit", "thin, 1", "thin, 2");
  for (std::size_t b = 0; b < binders.size(); ++b) {
    const double limit = of_fine[b] + share * (of_fine[b] - of_coarse[b]);
    fmt::print("{:12g}{:10.2f}{:10.2f}{:10.2f}", binders[b].shear / 1e6, of_coarse[b] / 1e6, of_fine[b] / 1e6,
               limit / 1e6);
    for (const auto& moduli : thin) fmt::print("{:+7.1f} %", 100.0 * (moduli[b] / limit - 1.0));
    fmt::print("\n");
  }
  return 0;
} catch (const breccia::Error& error) {
  fmt::print(stderr, "{}\n", error.what());
  return static_cast<int>(error.exit_code());
}
