#include "quasistatic/solvers/saddle_point/two_level_preconditioner.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Eigenvalues>

#include "quasistatic/solvers/saddle_point/around_nodes.hpp"
#include "quasistatic/solvers/saddle_point/coarse_stiffness.hpp"

namespace breccia::quasistatic {
namespace {

/// The largest eigenvalue of the stiffness of a cell over its diagonal. That of all cells together is not larger.
double largest_eigenvalue(const Moduli& moduli) {
  const auto stiffness = stiffness_of_cube(moduli);
  const Eigen::VectorXd scale = stiffness.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues().maxCoeff();
}

/// Number of nodes along the edge of the cube of an aggregate: four, and more where the coarse problem would be large.
int side_of_aggregates(const NodeLattice& lattice) {
  constexpr int least = 4, most_cubes = 12;
  return std::max(least, (*std::ranges::max_element(lattice.nodes) + most_cubes - 1) / most_cubes);
}

}  // namespace

TwoLevelPreconditioner::TwoLevelPreconditioner(SaddlePointOperator& saddle)
    : saddle_(&saddle),
      aggregates_(saddle.lattice(), saddle.similar_cells(), side_of_aggregates(saddle.lattice())),
      largest_(std::max(largest_eigenvalue({.bulk = 0.0, .shear = 1.0}),
                        largest_eigenvalue({.bulk = 2.0 / 3.0, .shear = 1.0}))),
      coarse_(aggregates_.unknowns(), coarse_stiffness(saddle.lattice(), saddle.similar_cells(), aggregates_),
              "the stiffness matrix of the coarse problem"),
      coarse_forces_(static_cast<std::size_t>(aggregates_.unknowns())),
      coarse_motions_(static_cast<std::size_t>(aggregates_.unknowns())),
      residual_(saddle.lattice()),
      step_(saddle.lattice()),
      work_(saddle.lattice()) {
  find_scale();
}

void TwoLevelPreconditioner::find_scale() {
  scale_ = diagonal_of_nodes(saddle_->lattice(), saddle_->similar_cells());
  for (double& value : scale_) value = value > 0.0 ? 1.0 / value : 0.0;
}

void TwoLevelPreconditioner::find_residual(const NodalField& forces, NodalField& displacement) {
  saddle_->multiply_similar(displacement, residual_);
  const double* from = forces.all().data();
  for (double& value : residual_.all()) value = *from++ - value;
}

void TwoLevelPreconditioner::smooth(NodalField& residual, NodalField& displacement) {
  // Reduces the errors with eigenvalues between the largest one and a tenth of it (Saad 2003, algorithm 12.1).
  constexpr int degree = 3;
  constexpr double ratio = 10.0;
  const double centre = 0.5 * largest_ * (1.0 + 1.0 / ratio), half = 0.5 * largest_ * (1.0 - 1.0 / ratio);
  const std::size_t entries = scale_.size();
  double rho = half / centre, of_step = 0.0, of_residual = 1.0 / centre;
  for (int k = 0;; ++k) {
    for (std::size_t component = 0; component < 3; ++component) {
      double *step = step_.component(component), *moved = displacement.component(component);
      const double *left = residual.component(component), *scale = scale_.data();
#pragma omp simd
      for (std::size_t index = 0; index < entries; ++index) {
        step[index] = of_step * step[index] + of_residual * scale[index] * left[index];
        moved[index] += step[index];
      }
    }
    if (k + 1 == degree) return;
    saddle_->multiply_similar(step_, work_);
    double* left = residual.all().data();
    for (const double value : std::as_const(work_).all()) *left++ -= value;
    const double next = 1.0 / (2.0 * centre / half - rho);
    of_step = next * rho;
    of_residual = 2.0 * next / half;
    rho = next;
  }
}

void TwoLevelPreconditioner::apply(const NodalField& forces, NodalField& displacement) {
  std::ranges::fill(displacement.all(), 0.0);
  std::ranges::copy(forces.all().first(residual_.all().size()), residual_.all().begin());
  smooth(residual_, displacement);
  find_residual(forces, displacement);
  aggregates_.restrict_to(coarse_forces_, residual_);
  coarse_.solve(coarse_forces_.data(), coarse_motions_.data());
  aggregates_.prolong(coarse_motions_, displacement);
  find_residual(forces, displacement);
  smooth(residual_, displacement);
}

}  // namespace breccia::quasistatic
