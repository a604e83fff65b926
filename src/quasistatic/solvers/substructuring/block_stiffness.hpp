#pragma once

#include <span>
#include <vector>

#include <Eigen/Dense>

#include "discretisation/cell_shape.hpp"
#include "quasistatic/operator/gap_operator.hpp"
#include "quasistatic/solvers/substructuring/block_grid.hpp"

namespace breccia::quasistatic {

/// A kind of block, whose stiffness depends on its shape, its cells, and on which displacements of its boundary are
/// held.
struct BlockKind {
  Block shape;
  std::vector<const CellShape<2>::Stiffness*> cells;  ///< stiffness matrices of the cells, row by row; null with gaps
  std::vector<bool> held;      ///< whether an unknown of the boundary is held, in the order of boundary_unknowns
  UnknownsOfFaces faces = {};  ///< the unknowns of faces
  /// A cell with gaps.
  struct WithGaps {
    const gaps::GapCell<2>* cell;
    GapOperator<2>::Stiffness stiffness;
  };
  std::vector<WithGaps> with_gaps = {};  ///< the cells with gaps, row by row
};

/// The stiffness of a block with the nodes inside it eliminated (theory, Eq. 36). The index i stands for the unknowns
/// inside the block, b for those of its boundary. Held unknowns are zero: they are coupled to nothing and have a
/// diagonal entry.
class BlockStiffness {
 public:
  BlockStiffness(const BlockKind& kind, double stiffness_of_held);

  /// Number of unknowns inside the block (inside_unknowns).
  [[nodiscard]] Eigen::Index inside() const noexcept { return factor_.rows(); }
  /// Schur complement S = A_bb - A_bi A_ii^-1 A_ib
  [[nodiscard]] Eigen::MatrixXd condensed() const;
  /// A_bi A_ii^-1 f_i: subtracted from the forces on the boundary, it accounts for the forces inside.
  [[nodiscard]] Eigen::VectorXd carried_by_boundary(Eigen::VectorXd forces_inside) const;
  /// u_i = A_ii^-1 (f_i - A_ib u_b)
  [[nodiscard]] Eigen::VectorXd displacement_inside(Eigen::VectorXd forces_inside,
                                                    const Eigen::VectorXd& boundary) const;

 private:
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void add_cell(const std::vector<bool>& held, std::span<const int> unknowns,
                const Eigen::Ref<const Eigen::MatrixXd>& stiffness);
  void factorise();
  template <class Rows>
  void solve_lower(Rows& right) const;
  void solve_upper(Eigen::VectorXd& right) const;

  Eigen::Index band_ = 0;     ///< half bandwidth of A_ii
  RowMajor factor_;           ///< lower Cholesky factor of A_ii: row i holds the columns i - band to i
  RowMajor inside_boundary_;  ///< A_ib
  Eigen::MatrixXd boundary_;  ///< A_bb
};

}  // namespace breccia::quasistatic
