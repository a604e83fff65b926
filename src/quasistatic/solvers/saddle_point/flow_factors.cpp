#include "quasistatic/solvers/saddle_point/flow_factors.hpp"

#include "breccia/error.hpp"

namespace breccia::quasistatic {

FlowFactors::FlowFactors(const SaddlePointOperator& saddle) {
  const auto& terms = saddle.forms().flows;
  const auto& stiffness = saddle.stiffness_of_flows();
  std::vector<int> rows(saddle.layout().seen(), -1);
  const auto row_of = [&](std::size_t entry) -> int& { return rows[entry - saddle.first_gap()]; };
  for (std::size_t term = 0; term < terms.count(); ++term) {
    terms.forms.for_parts(term, [&](std::size_t entry, double) {
      if (row_of(entry) >= 0) return;
      row_of(entry) = static_cast<int>(flows_.size());
      flows_.push_back(entry);
    });
  }
  if (flows_.empty()) return;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t term = 0; term < terms.count(); ++term) {
    terms.forms.for_parts(term, [&](std::size_t entry, double weight) {
      terms.forms.for_parts(term, [&](std::size_t other, double other_weight) {
        const int row = row_of(entry), column = row_of(other);
        if (row >= column) entries.emplace_back(row, column, stiffness[term] * weight * other_weight);
      });
    });
  }
  const auto size = static_cast<Eigen::Index>(flows_.size());
  Eigen::SparseMatrix<double> resistance(size, size);
  resistance.setFromTriplets(entries.begin(), entries.end());
  factors_.compute(resistance);
  if (factors_.info() == Eigen::Success && factors_.vectorD().minCoeff() > 0.0) return;
  throw NumericalError(
      "quasi-static solver: the resistance of flows in gaps cannot be factorised: a modulus may be zero, or the "
      "contrast beyond what numbers hold");
}

void FlowFactors::apply(const NodalField& right, NodalField& solution) const {
  if (flows_.empty()) return;
  const double* rights = right.all().data();
  double* solutions = solution.all().data();
  Eigen::VectorXd flows(static_cast<Eigen::Index>(flows_.size()));
  for (std::size_t flow = 0; flow < flows_.size(); ++flow)
    flows[static_cast<Eigen::Index>(flow)] = rights[flows_[flow]];
  flows = factors_.solve(flows).eval();
  for (std::size_t flow = 0; flow < flows_.size(); ++flow) {
    solutions[flows_[flow]] = flows[static_cast<Eigen::Index>(flow)];
  }
}

}  // namespace breccia::quasistatic
