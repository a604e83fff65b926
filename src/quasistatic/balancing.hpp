#pragma once

#include <optional>
#include <vector>

#include "coarse_solver.hpp"
#include "edge_averages.hpp"
#include "packed_symmetric.hpp"
#include "substructures.hpp"

namespace breccia::quasistatic {

/// Balancing domain decomposition by constraints with an adaptive coarse space: an approximate inverse of the stiffness
/// between the blocks, for any contrast of their cells (theory, Eqs. 37 to 39).
class Balancing {
 public:
  /// For the condensed stiffnesses of the kinds of blocks.
  Balancing(const Substructures& blocks, const std::vector<PackedSymmetric<double>>& condensed,
            double stiffness_of_held, int threads);

  /// z = M^-1 r
  void apply(const std::vector<double>& residual, std::vector<double>& result);

  [[nodiscard]] int coarse_unknowns() const noexcept { return static_cast<int>(coarse_right_.size()); }

 private:
  /// The answers of a block among its neighbours, in single precision: they need not be exact.
  struct Answers {
    PackedSymmetric<float> local;  ///< to forces on its edges, with vertices and constraints held
    Eigen::MatrixXf coarse;        ///< to unit values of its vertices and constraints, on its edges
  };

  void average_edges(const std::vector<PackedSymmetric<double>>& condensed);
  [[nodiscard]] Answers answers_of(const Substructures::Surrounded& surrounded, const Eigen::MatrixXd& condensed,
                                   Eigen::MatrixXd& coarse_stiffness) const;
  void number_constraints();

  const Substructures* blocks_;
  int threads_;
  std::vector<EdgeAverage> averages_;        ///< by kind of edge
  std::vector<Answers> answers_;             ///< by kind of surrounded block
  std::vector<std::vector<int>> coarse_of_;  ///< unknowns of the coarse problem by block: vertices, then constraints
  std::optional<CoarseSolver> coarse_solver_;
  std::vector<double> coarse_right_, coarse_solution_;
};

}  // namespace breccia::quasistatic
