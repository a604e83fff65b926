#include "breccia/films/film_problem.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"

namespace breccia {

template <int dim>
void require_sound(const FilmProblem<dim>& problem) {
  std::vector<std::string> mistakes;
  const auto require_positive = [&](double value, const char* name, const char* unit) {
    if (value > 0.0 && std::isfinite(value)) return;
    mistakes.push_back(fmt::format("{} must be positive and finite, got {}{}", name, value, unit));
  };
  require_positive(problem.thickness, "the thickness of the films", " m");
  require_positive(problem.grain.bulk, "the bulk modulus of the grains", " Pa");
  require_positive(problem.grain.shear, "the shear modulus of the grains", " Pa");
  if (!problem.crystals.empty() && problem.crystals.size() != problem.tessellation.size()) {
    mistakes.push_back(fmt::format("expected a crystal for each of {} grains, got {}", problem.tessellation.size(),
                                   problem.crystals.size()));
  }
  if constexpr (dim == 2) {
    require_positive(problem.elements.face_share, "the length of the elements", "");
  } else if (problem.elements.divisions < 1) {
    mistakes.push_back(
        fmt::format("the number of elements along an edge must be positive, got {}", problem.elements.divisions));
  }
  if (problem.layers && *problem.layers < 1) {
    mistakes.push_back(fmt::format("the number of layers across the films must be positive, got {}", *problem.layers));
  }
  const bool is_periodic = problem.tessellation.walls() == Walls::periodic;
  if (is_periodic != (problem.boundary == Boundary::periodic)) {
    mistakes.push_back(fmt::format("a {} tessellation does not go with a {} boundary",
                                   is_periodic ? "periodic" : "walled", name_of(problem.boundary)));
  }
  const bool has_debonded = !problem.debonded.faces.empty();
  if (has_debonded && problem.boundary != Boundary::periodic) {
    mistakes.emplace_back("films may be debonded where the boundary is periodic");
  }
  if (has_debonded && problem.layers && problem.debonded.kind != Debonding::open) {
    mistakes.emplace_back("films that are resolved by layers may be debonded as open gaps alone");
  }
  if (has_debonded && problem.debonded.kind == Debonding::spring) {
    require_positive(problem.debonded.springs.normal, "the normal stiffness of the springs", " Pa/m");
    require_positive(problem.debonded.springs.tangential, "the tangential stiffness of the springs", " Pa/m");
  }
  if (dim == 3 && !problem.tessellation.sites().film_shares.empty()) {
    mistakes.emplace_back("in three dimensions the films have nearly one thickness, without shares of the sites");
  }
  if (dim == 3 && problem.tessellation.size() < 2) {
    mistakes.emplace_back("in three dimensions there must be two grains at least");
  }
  if (dim == 3 && problem.boundary != Boundary::periodic) {
    mistakes.emplace_back("in three dimensions the boundary must be periodic");
  }
  if (!mistakes.empty()) throw InputError(fmt::format("films: {}", fmt::join(mistakes, "; ")));
}

template void require_sound(const FilmProblem<2>&);
template void require_sound(const FilmProblem<3>&);

}  // namespace breccia
