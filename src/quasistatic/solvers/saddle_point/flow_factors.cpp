#include "quasistatic/solvers/saddle_point/flow_factors.hpp"

#include <array>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "discretisation/cell_shape.hpp"
#include "quasistatic/solvers/saddle_point/around_nodes.hpp"

namespace breccia::quasistatic {
namespace {

/// Factorises a symmetric matrix of so many rows, of which one triangle is given; entries at the same place add up.
template <class Factors, class Entries>
void factorise(std::size_t rows, const Entries& entries, const char* what, Factors& factors) {
  const auto size = static_cast<Eigen::Index>(rows);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors.compute(matrix);
  if (factors.info() == Eigen::Success && factors.vectorD().minCoeff() > 0.0) return;
  throw NumericalError(fmt::format(
      "quasi-static solver: {} in gaps cannot be factorised: a modulus may be zero, or the contrast beyond what "
      "numbers hold",
      what));
}

}  // namespace

FlowFactors::FlowFactors(const SaddlePointOperator& saddle)
    : first_gap_(saddle.first_gap()),
      first_pressure_(saddle.first_pressure()),
      cells_(saddle.cells()),
      resistance_(first_pressure_ - first_gap_, 0.0) {
  factorise_resistance(saddle);
  factorise_schur_complement(saddle);
}

void FlowFactors::factorise_resistance(const SaddlePointOperator& saddle) {
  const auto& terms = saddle.forms().flows;
  const auto& stiffness = saddle.stiffness_of_flows();
  std::vector<int> rows(resistance_.size(), -1);
  const auto row_of = [&](std::size_t entry) -> int& { return rows[entry - first_gap_]; };
  for (std::size_t term = 0; term < terms.count(); ++term) {
    terms.forms.for_parts(term, [&](std::size_t entry, double weight) {
      resistance_[entry - first_gap_] += stiffness[term] * weight * weight;
      if (row_of(entry) >= 0) return;
      row_of(entry) = static_cast<int>(flows_.size());
      flows_.push_back(entry);
    });
  }
  Entries entries;
  for (std::size_t term = 0; term < terms.count(); ++term) {
    terms.forms.for_parts(term, [&](std::size_t entry, double weight) {
      terms.forms.for_parts(term, [&](std::size_t other, double other_weight) {
        const int row = row_of(entry), column = row_of(other);
        if (row >= column) entries.emplace_back(row, column, stiffness[term] * weight * other_weight);
      });
    });
  }
  if (!flows_.empty()) factorise(flows_.size(), entries, "the resistance of flows", of_flows_);
}

/// 1/k + a/G by cell. The nodes of a cell resist a pressure as the stiffer cells around them do.
std::vector<double> FlowFactors::compliance_of_pressures(const SaddlePointOperator& saddle) const {
  using Shape = CellShape<3>;
  // For a pressure that varies slowly it is 1/(4/3 + 2/3), for one that alternates much less.
  constexpr double of_shear = 0.1;
  const auto& lattice = saddle.lattice();
  const auto& cells = saddle.similar_cells();
  const auto around = shear_around_nodes(lattice, cells);
  std::vector<double> compliance;
  compliance.reserve(cells_);
  for_each_index(Index<3>{}, lattice.own_cells(), [&](const Index<3>& cell) {
    const auto kind = cells.kind_of.row_at(cell[1], cell[2])[cell[0]];
    double of_nodes = 0.0;
    for (int node = 0; node < Shape::nodes; ++node) {
      of_nodes += 1.0 / (Shape::nodes * around[index_of_node(lattice, cell, node)]);
    }
    compliance.push_back(1.0 / saddle.bulk_of_pressures()[kind] + of_shear * of_nodes);
  });
  return compliance;
}

void FlowFactors::factorise_schur_complement(const SaddlePointOperator& saddle) {
  Entries entries;
  const auto compliance = compliance_of_pressures(saddle);
  for (std::size_t cell = 0; cell < cells_; ++cell) {
    entries.emplace_back(static_cast<int>(cell), static_cast<int>(cell), compliance[cell]);
  }
  // The cells on both sides of the face of each flow, with the weights of the flow in their volume changes.
  struct Side {
    int cell = -1;
    double weight = 0.0;
  };
  std::vector<std::array<Side, 2>> sides(resistance_.size());
  const auto& forms = saddle.forms();
  for (std::size_t gap = 0; gap < forms.cells.size(); ++gap) {
    forms.volumes.for_parts(gap, [&](std::size_t entry, double weight) {
      if (entry < first_gap_ || resistance_[entry - first_gap_] == 0.0) return;
      auto& of_flow = sides[entry - first_gap_];
      of_flow[of_flow[0].cell < 0 ? 0 : 1] = {static_cast<int>(forms.cells[gap]), weight};
    });
  }
  for (std::size_t flow = 0; flow < sides.size(); ++flow) {
    for (const auto& [cell, weight] : sides[flow]) {
      for (const auto& [other, other_weight] : sides[flow]) {
        if (other < 0 || cell < other) continue;
        entries.emplace_back(cell, other, weight * other_weight / resistance_[flow]);
      }
    }
  }
  factorise(cells_, entries, "the Schur complement of pressures", of_pressures_);
}

void FlowFactors::apply(const NodalField& right, NodalField& solution) const {
  const double* rights = right.all().data();
  double* solutions = solution.all().data();
  if (!flows_.empty()) {
    Eigen::VectorXd flows(static_cast<Eigen::Index>(flows_.size()));
    for (std::size_t flow = 0; flow < flows_.size(); ++flow)
      flows[static_cast<Eigen::Index>(flow)] = rights[flows_[flow]];
    flows = of_flows_.solve(flows).eval();
    for (std::size_t flow = 0; flow < flows_.size(); ++flow)
      solutions[flows_[flow]] = flows[static_cast<Eigen::Index>(flow)];
  }
  const auto cells = static_cast<Eigen::Index>(cells_);
  Eigen::Map<Eigen::VectorXd>(solutions + first_pressure_, cells) =
      of_pressures_.solve(Eigen::Map<const Eigen::VectorXd>(rights + first_pressure_, cells));
}

}  // namespace breccia::quasistatic
