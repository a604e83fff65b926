#include "breccia/quasistatic/apparent_moduli.hpp"

#include <array>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "quasistatic/reduced/sampling.hpp"

namespace breccia {

template <int dim>
std::vector<double> apparent_moduli(const QuasistaticProblem<dim>& problem, std::span<const Load> loads) {
  for (const auto& material : problem.materials) {
    if (material.bulk.is_elastic() && material.shear.is_elastic()) continue;
    throw InputError(fmt::format("apparent moduli: {} relaxes; expected elastic materials", material.name));
  }
  if (problem.materials.empty()) throw InputError("apparent moduli: expected a material for each phase");
  // The reduced basis of a single elastic solution is exact for the moduli of that solution. Any phase can be declared
  // to vary in it, since its moduli take a single value.
  constexpr PhaseIndex any = 0;
  const auto& first = problem.materials[any];
  const Moduli moduli = {.bulk = first.bulk.equilibrium(), .shear = first.shear.equilibrium()};
  std::vector<double> apparent;
  for (const auto& response : sample_responses(problem, loads, matrix_path(any, std::array{moduli})).responses) {
    apparent.push_back(response.modulus(moduli));
  }
  return apparent;
}

template std::vector<double> apparent_moduli(const QuasistaticProblem<2>&, std::span<const Load>);
template std::vector<double> apparent_moduli(const QuasistaticProblem<3>&, std::span<const Load>);

}  // namespace breccia
