#include "quasistatic/solvers/saddle_point/two_level_preconditioner.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <Eigen/Eigenvalues>

#include "discretisation/cell_shape.hpp"
#include "quasistatic/solvers/saddle_point/around_nodes.hpp"

namespace breccia::quasistatic {
namespace {

using Shape = CellShape<3>;

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
      coarse_forces_(static_cast<std::size_t>(aggregates_.unknowns())),
      coarse_motions_(static_cast<std::size_t>(aggregates_.unknowns())),
      residual_(saddle.lattice()),
      step_(saddle.lattice()),
      work_(saddle.lattice()) {
  find_scale();
  make_coarse();
}

void TwoLevelPreconditioner::find_scale() {
  scale_ = diagonal_of_nodes(saddle_->lattice(), saddle_->similar_cells());
  for (double& value : scale_) value = value > 0.0 ? 1.0 / value : 0.0;
}

/// The coarse matrix, from the cells whose nodes are in different aggregates; the others do not resist rigid motions.
void TwoLevelPreconditioner::make_coarse() {
  using Block = Eigen::Matrix<double, 6, 6>;
  const auto& lattice = saddle_->lattice();
  const auto& cells = saddle_->similar_cells();
  const auto shear = stiffness_of_cube({.bulk = 0.0, .shear = 1.0}),
             bulk = stiffness_of_cube({.bulk = 1.0, .shear = 0.0});
  struct Unknowns {
    int first, count;
  };
  std::map<std::pair<int, int>, Block> blocks;
  std::map<int, int> counts;
  for_each_index(Index<3>{}, lattice.cells, [&](const Index<3>& cell) {
    std::array<Unknowns, Shape::nodes> unknowns{};
    std::array<RigidAggregates::Motions, Shape::nodes> motions;
    bool is_rigid = true;
    for (int n = 0; n < Shape::nodes; ++n) {
      auto node = Shape::corner(n);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node[axis] = (node[axis] + cell[axis]) % lattice.nodes[axis];
      }
      const auto index = lattice.arrays.row_at(node[1], node[2]) + static_cast<std::size_t>(node[0]);
      const auto at = static_cast<std::size_t>(n);
      unknowns[at] = {aggregates_.first_unknown(index), aggregates_.motions_of(index)};
      motions[at] = aggregates_.motions(node);
      counts[unknowns[at].first] = unknowns[at].count;
      is_rigid = is_rigid && unknowns[at].first == unknowns[0].first;
    }
    if (is_rigid) return;
    const auto kind = cells.kind_of.row_at(cell[1], cell[2])[cell[0]];
    const Shape::Stiffness stiffness = cells.shear[kind] * shear + cells.bulk[kind] * bulk;
    for (std::size_t a = 0; a < motions.size(); ++a) {
      for (std::size_t b = 0; b < motions.size(); ++b) {
        if (unknowns[a].first > unknowns[b].first) continue;
        auto& block = blocks.try_emplace({unknowns[a].first, unknowns[b].first}, Block::Zero()).first->second;
        block += motions[a].transpose() *
                 stiffness.block<3, 3>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b)) * motions[b];
      }
    }
  });
  MatrixEntries entries;
  for (const auto& [place, block] : blocks) {
    for (int i = 0; i < counts[place.first]; ++i) {
      for (int j = place.first == place.second ? i : 0; j < counts[place.second]; ++j) {
        entries.add(place.first + i, place.second + j, block(i, j));
      }
    }
  }
  // A little of its own stiffness holds the first aggregate, and so the translations of the box, which have no forces.
  constexpr double little = 1e-6;
  for (int unknown = 0; unknown < counts[0]; ++unknown) {
    entries.add(unknown, unknown, little * blocks[{0, 0}](unknown, unknown));
  }
  coarse_.emplace(aggregates_.unknowns(), std::move(entries), "the stiffness matrix of the coarse problem");
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
  coarse_->solve(coarse_forces_.data(), coarse_motions_.data());
  aggregates_.prolong(coarse_motions_, displacement);
  find_residual(forces, displacement);
  smooth(residual_, displacement);
}

}  // namespace breccia::quasistatic
