#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "quasistatic/solvers/substructuring/coarse_solver.hpp"
#include "quasistatic/solvers/substructuring/edge_averages.hpp"
#include "quasistatic/solvers/substructuring/packed_symmetric.hpp"
#include "quasistatic/solvers/substructuring/substructures.hpp"

namespace breccia::quasistatic {

/// Balancing domain decomposition by constraints (BDDC) with an adaptive coarse space: an approximate inverse of the
/// condensed stiffness between the blocks, whose quality does not depend on the contrast of the cells (theory, Eqs. 37
/// to 39). Every process has the blocks of its part of the box, and exchanges values with its neighbours.
class BddcPreconditioner {
 public:
  /// Takes the condensed stiffnesses [Pa] by kind of block. `stiffness_of_held` [Pa] is the diagonal entry of held
  /// unknowns. Throws NumericalError when the coarse problem cannot be factorised.
  BddcPreconditioner(const Substructures& blocks, const std::vector<PackedSymmetric<double>>& condensed,
                     double stiffness_of_held, int threads);

  /// Computes z = M^-1 r for a residual r of all unknowns between the blocks; z is zero for held unknowns. Processes
  /// that share an unknown have the same value of it, in both vectors.
  void apply(const std::vector<double>& residual, std::vector<double>& result);

  /// Number of unknowns of the coarse problem, of all processes.
  [[nodiscard]] std::int64_t coarse_unknowns() const { return coarse_solver_->unknowns(); }

 private:
  /// The two parts of M^-1 on one kind of block with neighbours, weighted by the averages at its edges. Single
  /// precision is enough for a preconditioner.
  struct BlockSolvers {
    PackedSymmetric<float> local;  ///< D W D': displacements of the edges under forces on them, constraints held
    Eigen::MatrixXf coarse;        ///< D Phi: displacements of the edges for unit values of vertices and constraints
  };
  /// The averages at the four edges of one block.
  struct EdgesOfBlock {
    Eigen::MatrixXd constraints;  ///< q, a column for each constraint
    Eigen::MatrixXd weight;       ///< D, block diagonal by edge
  };

  void average_edges(const std::vector<PackedSymmetric<double>>& condensed);
  void make_block_solvers(const std::vector<PackedSymmetric<double>>& condensed,
                          std::vector<Eigen::MatrixXd>& coarse_stiffness);
  [[nodiscard]] EdgesOfBlock edges_of(const Substructures::BlockWithNeighbours& block, Eigen::Index on_edges) const;
  [[nodiscard]] BlockSolvers block_solvers_of(const Substructures::BlockWithNeighbours& block,
                                              const Eigen::MatrixXd& condensed,
                                              Eigen::MatrixXd& coarse_stiffness) const;
  /// The first constraint of each edge in the numbering of the coarse problem on this process, and the number of the
  /// coarse unknowns that belong to it.
  struct CoarseNumbers {
    std::vector<int> first_of_edge;
    int owned;
  };
  [[nodiscard]] CoarseNumbers number_coarse_unknowns();
  void share_coarse_unknowns(const CoarseNumbers& numbers);
  [[nodiscard]] int constraints_of(int edge) const;
  void factorise_coarse_problem(const std::vector<Eigen::MatrixXd>& coarse_stiffness, double stiffness_of_held,
                                int owned);
  template <class Work>
  void for_each_block(const Work& work) const;

  const Substructures* blocks_;
  int threads_;
  std::vector<EdgeAverage> averages_;        ///< averages by kind of edge
  std::vector<BlockSolvers> block_solvers_;  ///< solvers by kind of block with neighbours
  std::vector<std::vector<int>> coarse_of_;  ///< unknowns of the coarse problem by block: vertices, then constraints
  SharedValues shared_coarse_;
  std::optional<CoarseSolver> coarse_solver_;
  std::vector<double> coarse_right_, coarse_solution_;
};

}  // namespace breccia::quasistatic
