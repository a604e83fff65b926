#include "quasistatic/solvers/elastic_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/contrast.hpp"
#include "quasistatic/operator/block_division.hpp"
#include "quasistatic/operator/plane_division.hpp"
#include "quasistatic/solvers/direct/assembled_solver.hpp"
#include "quasistatic/solvers/lattice/lattice_solver.hpp"
#include "quasistatic/solvers/saddle_point/saddle_point_solver.hpp"
#include "quasistatic/solvers/substructuring/substructuring_solver.hpp"

namespace breccia::quasistatic {

template <int dim>
ElasticSolver<dim>::ElasticSolver(const ElasticOperator<dim>& elastic_operator, const LinearOptions& options,
                                  bool is_direct)
    : elastic_operator_(&elastic_operator),
      tolerance_(options.tolerance),
      prescribed_(elastic_operator.boundary() == Boundary::traction ? 0.0 : 1.0) {
  effort_.is_direct = is_direct;
  effort_.unknowns = elastic_operator.unknowns();
}

template <int dim>
void ElasticSolver<dim>::set_moduli(std::span<const Moduli> moduli) {
  double stiffest = 0.0;
  for (const auto& [bulk, shear] : moduli) stiffest = std::max(stiffest, bulk + shear);
  constexpr double rounding = 2e-15;
  rounding_ = rounding * stiffest * std::sqrt(static_cast<double>(effort_.unknowns));
  moduli_ = solvable(moduli);
  update_stiffness(moduli_);
}

template <int dim>
std::vector<Moduli> ElasticSolver<dim>::solvable(std::span<const Moduli> moduli) const {
  constexpr double of_softest = 1e-8, of_stiffest = 1e-11;  // less of the stiffest is lost in the rounding of factors
  const auto [bulk, shear] = least_of_solids(moduli);
  double stiffest = 0.0;
  for (const auto& phase : moduli) stiffest = std::max({stiffest, phase.bulk, phase.shear});
  const double trace = std::max(of_softest * std::min(bulk, shear), of_stiffest * stiffest);
  std::vector<Moduli> with_trace(moduli.begin(), moduli.end());
  std::ranges::replace_if(
      with_trace, [](const Moduli& phase) { return is_void(phase); }, Moduli{.bulk = trace, .shear = trace});
  return with_trace;
}

template <int dim>
bool ElasticSolver<dim>::is_small(double residual, double largest) const noexcept {
  return residual <= tolerance_ * load_ || is_rounding(residual, largest);
}

template <int dim>
bool ElasticSolver<dim>::is_rounding(double residual, double largest) const noexcept {
  return residual <= rounding_ * std::max(prescribed_, largest);
}

template <int dim>
std::string ElasticSolver<dim>::accuracy_wanted() const {
  return fmt::format("a residual of {:.1e} of the load", tolerance_);
}

template <int dim>
void ElasticSolver<dim>::count_iterations(int iterations) {
  effort_.iterations += iterations;
  effort_.most_iterations = std::max(effort_.most_iterations, iterations);
}

template <int dim>
Displacement ElasticSolver<dim>::solve(Forces forces, Displacement displacement, std::optional<double> least_energy) {
  least_energy_ = least_energy;
  elastic_operator_->condense(moduli_, forces);
  check(VecNorm(forces.fluctuation(), NORM_2, &load_), "reading the load");
  const auto [is_converged, residual] = iterate(forces.take_fluctuation(), displacement);
  // Where the prescribed displacements are the whole solution, as in a homogeneous box, the load consists of rounding
  // errors.
  const double least = std::max(prescribed_ * rounding_ / tolerance_, std::numeric_limits<double>::min());
  const double relative = residual / std::max(load_, least);
  if (!is_converged) {
    throw NumericalError(fmt::format(
        "quasi-static solver: the iteration stopped at a residual of {:.1e} of the load after {} iterations, "
        "wanted {}; the contrast of the moduli may be too high{}",
        relative, effort_.most_iterations, accuracy_wanted(),
        effort_.is_direct
            ? ""
            : " for an iterative solver: tests.quasistatic.range = \"times\", or linear = \"direct\" on a "
              "coarse grid, may serve"));
  }
  ++effort_.solves;
  effort_.largest_residual = std::max(effort_.largest_residual, relative);
  elastic_operator_->recover_phase_strains(moduli_, forces, displacement);
  return displacement;
}

namespace {

std::unique_ptr<ElasticSolver<2>> make_iterative_solver(const ElasticOperator<2>& elastic_operator,
                                                        const LinearOptions& options) {
  const bool is_periodic = elastic_operator.boundary() == Boundary::periodic;
  // Every process needs at least one block.
  if (BlockDivision::among(parallel::ranks(), elastic_operator.grid().cells, is_periodic)) {
    return std::make_unique<SubstructuringSolver>(elastic_operator, options);
  }
  // Multigrid knows rigid motions of nodes alone.
  const auto preconditioner = elastic_operator.has_gaps() ? Preconditioner::factors : Preconditioner::multigrid;
  return std::make_unique<AssembledSolver<2>>(elastic_operator, options, preconditioner);
}

std::unique_ptr<ElasticSolver<3>> make_iterative_solver(const ElasticOperator<3>& elastic_operator,
                                                        const LinearOptions& options) {
  if (elastic_operator.has_gaps()) {
    // Aggregates of nodes must not meet themselves at the end of a periodic box.
    constexpr int least_cells = 8;
    if (parallel::ranks() == 1 && std::ranges::min(elastic_operator.grid().cells) >= least_cells) {
      return std::make_unique<SaddlePointSolver>(elastic_operator, options);
    }
    return std::make_unique<AssembledSolver<3>>(elastic_operator, options, Preconditioner::factors);
  }
  // Every process needs at least one plane of nodes.
  const bool is_periodic = elastic_operator.boundary() == Boundary::periodic;
  const int planes = elastic_operator.grid().cells[2] + (is_periodic ? 0 : 1);
  if (PlaneDivision::among(parallel::ranks(), planes))
    return std::make_unique<LatticeSolver>(elastic_operator, options);
  return std::make_unique<AssembledSolver<3>>(elastic_operator, options, Preconditioner::multigrid);
}

}  // namespace

template <int dim>
std::unique_ptr<ElasticSolver<dim>> make_elastic_solver(const ElasticOperator<dim>& elastic_operator,
                                                        const LinearOptions& options) {
  // Opposite sides of a single periodic cell are the same nodes, so it cannot be cut into blocks.
  const bool is_one_cell =
      elastic_operator.boundary() == Boundary::periodic && std::ranges::min(elastic_operator.grid().cells) == 1;
  if (options.is_direct(elastic_operator.unknowns(), dim) || is_one_cell) {
    return std::make_unique<AssembledSolver<dim>>(elastic_operator, options, Preconditioner::factors);
  }
  return make_iterative_solver(elastic_operator, options);
}

template class ElasticSolver<2>;
template class ElasticSolver<3>;
template std::unique_ptr<ElasticSolver<2>> make_elastic_solver(const ElasticOperator<2>&, const LinearOptions&);
template std::unique_ptr<ElasticSolver<3>> make_elastic_solver(const ElasticOperator<3>&, const LinearOptions&);

}  // namespace breccia::quasistatic
