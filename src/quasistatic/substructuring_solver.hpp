#pragma once

#include <optional>
#include <vector>

#include "balancing.hpp"
#include "elastic_solver.hpp"
#include "packed_symmetric.hpp"
#include "substructures.hpp"

namespace breccia::quasistatic {

/// Works on one process without assembling K: the nodes inside blocks of cells are eliminated, and conjugate gradients
/// find the displacements of the others, preconditioned by balancing (theory, section 9).
class SubstructuringSolver final : public ElasticSolver {
 public:
  SubstructuringSolver(const ElasticBox& box, const LinearOptions& options);

  /// The preconditioner is always that of the present moduli.
  void refresh() override {}

 private:
  void take(std::span<const Moduli> moduli) override;
  End iterate(const Field& forces, Field& displacement) override;
  /// Adds the w for which K w = residual, as far as its own residual is small beside the load. Returns the norm of
  /// that.
  double correct(const Field& residual, double largest, Field& displacement);
  /// y = S x
  void multiply(const std::vector<double>& x, std::vector<double>& y) const;
  /// Forces on the interface, with what it has to carry of those on the nodes inside blocks.
  [[nodiscard]] std::vector<double> condense(const double* forces) const;
  /// Adds the displacements of the interface and, under forces on them, of the nodes inside to those of all nodes.
  void expand(const double* forces, const std::vector<double>& interface, double* displacement) const;
  /// Calls work(block, its stiffness) for each block.
  template <class Work>
  void for_each_block(const Work& work) const;
  [[nodiscard]] std::size_t place_of(int column, int row) const noexcept;
  [[nodiscard]] Eigen::VectorXd inside_of(const Block& block, const double* nodal) const;

  Substructures blocks_;
  int threads_;
  std::vector<std::size_t> place_of_unknown_;  ///< among the nodal values
  std::vector<Moduli> moduli_;
  double stiffest_ = 0.0;
  std::vector<CellMatrix> cells_;                   ///< by kind of cell
  std::vector<PackedSymmetric<double>> condensed_;  ///< by kind of block
  std::optional<Balancing> balancing_;
};

}  // namespace breccia::quasistatic
