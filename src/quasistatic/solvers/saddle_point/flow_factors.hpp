#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/SparseCholesky>

#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"

namespace breccia::quasistatic {

/// The inverse of the resistance H of the flows, by sparse factors. H couples the flows around a facet alone.
class FlowFactors {
 public:
  /// Takes the present moduli of the operator.
  explicit FlowFactors(const SaddlePointOperator& saddle);

  /// Finds flows, as entries of a field.
  void apply(const NodalField& right, NodalField& solution) const;

 private:
  std::vector<std::size_t> flows_;  ///< entries of the flows
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace breccia::quasistatic
