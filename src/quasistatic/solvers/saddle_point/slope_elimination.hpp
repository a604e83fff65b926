#pragma once

#include <cstddef>
#include <vector>

#include "quasistatic/solvers/saddle_point/saddle_point_operator.hpp"

namespace breccia::quasistatic {

/// The exact elimination of the slopes of particles, each of which is tied to nodes alone.
class SlopeElimination {
 public:
  /// Takes the present moduli of the operator, which must outlive this object.
  explicit SlopeElimination(const SaddlePointOperator& saddle);

  /// forces = right, and on the nodes those that remain when the slopes are eliminated.
  void condense(const NodalField& right, NodalField& forces) const;
  /// Sets the slopes to those in equilibrium with the displacements of the nodes.
  void recover(const NodalField& right, NodalField& displacement) const;

 private:
  /// Calls action(term, stiffness, entry of its slope, weight of the slope).
  template <class Action>
  void for_terms(const Action& action) const;

  const SaddlePointOperator* saddle_;
  std::vector<std::size_t> slope_of_term_;
  std::vector<double> weight_of_slope_;
  std::vector<double> compliance_;  ///< by value of a gap; zero for flows
};

}  // namespace breccia::quasistatic
