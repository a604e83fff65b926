#include "breccia/films/film_moduli.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "films/film_composite.hpp"

namespace breccia {

template <int dim>
std::vector<std::vector<double>> film_moduli(const FilmProblem<dim>& problem, std::span<const Moduli> binders,
                                             std::span<const Load> loads) {
  for (const auto& [bulk, shear] : binders) {
    if (bulk > 0.0 && shear > 0.0 && std::isfinite(bulk) && std::isfinite(shear)) continue;
    throw InputError(fmt::format(
        "films: the moduli of the binder must be positive and finite, got K = {} Pa and G = {} Pa", bulk, shear));
  }
  const films::FilmComposite<dim> composite(problem);
  films::FilmSolver<dim> solver(composite);
  std::vector<std::vector<double>> moduli;
  for (const auto& binder : binders) {
    solver.prepare(std::array{binder.shear, binder.bulk});
    auto& of_binder = moduli.emplace_back();
    for (const auto load : loads) of_binder.push_back(solver.modulus(load, solver.solve(load, composite.zero())));
  }
  return moduli;
}

template std::vector<std::vector<double>> film_moduli(const FilmProblem<2>&, std::span<const Moduli>,
                                                      std::span<const Load>);
template std::vector<std::vector<double>> film_moduli(const FilmProblem<3>&, std::span<const Moduli>,
                                                      std::span<const Load>);

}  // namespace breccia
