#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "quasistatic/solvers/elastic_solver.hpp"
#include "quasistatic/solvers/substructuring/bddc_preconditioner.hpp"
#include "quasistatic/solvers/substructuring/packed_symmetric.hpp"
#include "quasistatic/solvers/substructuring/substructures.hpp"

namespace breccia::quasistatic {

/// Solves by substructuring, without assembling K: the nodes inside blocks of cells are eliminated, and conjugate
/// gradients with the BDDC preconditioner find the displacements of the interface, the nodes between blocks (theory,
/// section 9). Every process has whole blocks; vectors of the interface have the unknowns that belong to the process,
/// followed by copies of those that belong to its neighbours.
class SubstructuringSolver final : public ElasticSolver<2> {
 public:
  SubstructuringSolver(const ElasticOperator<2>& elastic_operator, const LinearOptions& options);

  /// Does nothing: the preconditioner is made with every set of moduli.
  void update_preconditioner() override {}

  /// Number of unknowns of the coarse problem of the present preconditioner, of all processes.
  [[nodiscard]] std::int64_t coarse_unknowns() const { return preconditioner_.value().coarse_unknowns(); }

 private:
  void update_stiffness(std::span<const Moduli> moduli) override;
  Convergence iterate(NodalVector on_nodes, Displacement& displacement) override;
  /// Solves K w = residual by conjugate gradients until the residual is small compared with the load, and adds w to the
  /// displacement. Returns the norm of the remaining residual.
  double correct(const Displacement& residual, double largest, Displacement& displacement);
  /// Scalar product of two vectors of the interface.
  [[nodiscard]] double product(const std::vector<double>& a, const std::vector<double>& b) const;
  /// y = S x, with the condensed stiffness S of the interface
  void multiply(const std::vector<double>& x, std::vector<double>& y) const;
  /// Forces on the interface, including the condensed forces on the nodes inside the blocks.
  [[nodiscard]] std::vector<double> condense(const double* forces) const;
  /// Adds the displacements of the interface, and the displacements of the nodes inside the blocks that follow from
  /// them and from the forces inside, to the displacements of all nodes.
  void expand(const double* forces, const std::vector<double>& interface, double* displacement) const;
  /// Calls work(number of the block, its stiffness) for each block.
  template <class Work>
  void for_each_block(const Work& work) const;
  [[nodiscard]] std::size_t index_of(const Block& block, const BlockUnknown& unknown) const noexcept;
  /// The indices of the unknowns inside a block among the values of this process in a nodal vector.
  [[nodiscard]] std::vector<std::size_t> indices_inside(int number) const;

  Substructures blocks_;
  int threads_;
  std::vector<std::size_t> index_of_unknown_;  ///< index of this process' unknowns of the interface among nodal values
  double stiffest_ = 0.0;
  std::vector<CellShape<2>::Stiffness> cells_;      ///< stiffness matrices, by kind of cell
  std::vector<PackedSymmetric<double>> condensed_;  ///< condensed stiffnesses, by kind of block
  std::optional<BddcPreconditioner> preconditioner_;
};

}  // namespace breccia::quasistatic
