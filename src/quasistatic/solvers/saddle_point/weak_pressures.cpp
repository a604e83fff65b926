#include "quasistatic/solvers/saddle_point/weak_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "breccia/error.hpp"

#include "quasistatic/solvers/saddle_point/around_nodes.hpp"
#include "quasistatic/solvers/saddle_point/cell_volumes.hpp"

namespace breccia::quasistatic {
namespace {

using Shape = CellShape<3>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Calls action(index of a cell, cell) for all cells.
template <class Action>
void for_cells(const SaddlePointOperator& saddle, const Action& action) {
  int index = 0;
  for_each_index(Index<3>{}, saddle.lattice().cells, [&](const Index<3>& cell) { action(index++, cell); });
}

/// The entry of a node that is repeated behind the end of its row.
std::size_t without_repetition(const SaddlePointOperator& saddle, std::size_t entry) {
  if (entry >= saddle.first_gap()) return entry;
  const auto& lattice = saddle.lattice();
  const auto in_row = entry % lattice.arrays.row;
  return in_row == static_cast<std::size_t>(lattice.nodes[0]) ? entry - in_row : entry;
}

/// The inverse of the diagonal of A, by entry of a field before the pressures; zero for entries without stiffness.
Eigen::VectorXd mobility_of_entries(const SaddlePointOperator& saddle) {
  Eigen::VectorXd mobility = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(saddle.first_pressure()));
  const auto of_nodes = diagonal_of_nodes(saddle.lattice(), saddle.similar_cells());
  for (std::size_t component = 0; component < 3; ++component) {
    std::ranges::copy(of_nodes, mobility.data() + component * of_nodes.size());
  }
  // A value of a gap is a slope or a flow.
  std::ranges::transform(saddle.diagonal_of_slopes(), saddle.diagonal_of_flows(), mobility.data() + saddle.first_gap(),
                         std::plus<>{});
  for (double& value : mobility) value = value > 0.0 ? 1.0 / value : 0.0;
  return mobility;
}

/// The forces B' of the pressures of cells, by entry of a field: the weights of entries in their volume changes.
Eigen::SparseMatrix<double> forces_of_cells(const SaddlePointOperator& saddle) {
  const auto& lattice = saddle.lattice();
  Triplets entries;
  entries.reserve(saddle.cells() * Shape::dofs);
  for_cells(saddle, [&](int index, const Index<3>& cell) {
    if (saddle.has_gap(static_cast<std::size_t>(index))) return;
    for (int node = 0; node < Shape::nodes; ++node) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        entries.emplace_back(static_cast<int>(axis * lattice.size() + index_of_node(lattice, cell, node)), index,
                             weight_in_volume(static_cast<std::size_t>(node), axis));
      }
    }
  });
  const auto& forms = saddle.forms();
  for (std::size_t gap = 0; gap < forms.cells.size(); ++gap) {
    forms.volumes.for_parts(gap, [&](std::size_t entry, double weight) {
      entries.emplace_back(static_cast<int>(without_repetition(saddle, entry)), static_cast<int>(forms.cells[gap]),
                           weight);
    });
  }
  Eigen::SparseMatrix<double> forces(static_cast<Eigen::Index>(saddle.first_pressure()),
                                     static_cast<Eigen::Index>(saddle.cells()));
  forces.setFromTriplets(entries.begin(), entries.end());
  return forces;
}

}  // namespace

WeakPressures::WeakPressures(const SaddlePointOperator& saddle) : first_pressure_(saddle.first_pressure()) {
  find_amplitudes(saddle);
  Eigen::VectorXd compliance(static_cast<Eigen::Index>(saddle.cells()));
  for (Eigen::Index cell = 0; cell < compliance.size(); ++cell) {
    compliance[cell] = 1.0 / saddle.bulk_of_pressures()[saddle.kinds()[cell]];
  }
  compliance_of_uniform_ = compliance.sum();
  // S = 1/k + B A^-1 B', with the diagonal of A, which is enough where neighbours move against one another.
  const auto mobility = mobility_of_entries(saddle);
  const Matrix forces = forces_of_cells(saddle) * alternating_;
  const Matrix of_forces = forces.transpose() * (mobility.asDiagonal() * forces).eval();
  Matrix schur = of_forces + Matrix(alternating_.transpose() * (compliance.asDiagonal() * alternating_).eval());
  // An amplitude without cells has no pressure, and those that share few cells depend on one another.
  constexpr double little = 1e-8;
  for (Eigen::Index amplitude = 0; amplitude < schur.rows(); ++amplitude) {
    auto& own = schur.coeffRef(amplitude, amplitude);
    own = own > 0.0 ? (1.0 + little) * own : 1.0;
  }
  of_amplitudes_.compute(schur);
  if (of_amplitudes_.info() == Eigen::Success && of_amplitudes_.vectorD().minCoeff() > 0.0) return;
  throw NumericalError(
      "quasi-static solver: the pressures that alternate from cell to cell cannot be factorised: a modulus may be "
      "zero, or the contrast beyond what numbers hold");
}

/// The amplitudes are trilinear between places some cells apart.
void WeakPressures::find_amplitudes(const SaddlePointOperator& saddle) {
  constexpr int cells_between = 3, most_along_an_axis = 16;
  const auto cells = saddle.lattice().cells;
  Index<3> places{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    places[axis] = std::clamp(cells[axis] / cells_between, 1, most_along_an_axis);
  }
  Triplets entries;
  for_cells(saddle, [&](int index, const Index<3>& cell) {
    for (int corner = 0; corner < Shape::nodes; ++corner) {
      const auto is_upper = Shape::corner(corner);
      double weight = (cell[0] + cell[1] + cell[2]) % 2 == 0 ? 1.0 : -1.0;
      Index<3> place{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double at = (cell[axis] + 0.5) * places[axis] / cells[axis], lower = std::floor(at);
        weight *= is_upper[axis] == 1 ? at - lower : 1.0 - (at - lower);
        place[axis] = (static_cast<int>(lower) + is_upper[axis]) % places[axis];
      }
      entries.emplace_back(index, place[0] + places[0] * (place[1] + places[1] * place[2]), weight);
    }
  });
  alternating_.resize(static_cast<Eigen::Index>(saddle.cells()), places[0] * places[1] * places[2]);
  alternating_.setFromTriplets(entries.begin(), entries.end());
}

void WeakPressures::add_to(const NodalField& right, NodalField& solution) const {
  const auto cells = alternating_.rows();
  const Eigen::Map<const Eigen::VectorXd> volumes(right.all().data() + first_pressure_, cells);
  const Eigen::VectorXd amplitudes = of_amplitudes_.solve(alternating_.transpose() * volumes);
  Eigen::Map<Eigen::VectorXd> pressures(solution.all().data() + first_pressure_, cells);
  pressures += alternating_ * amplitudes;
  pressures.array() += volumes.sum() / compliance_of_uniform_;
}

}  // namespace breccia::quasistatic
