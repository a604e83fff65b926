#pragma once

#include <span>
#include <vector>

#include <Eigen/Dense>

#include "breccia/discretisation/cell.hpp"

#include "block_grid.hpp"

namespace breccia::quasistatic {

/// What makes the stiffness of a block: its shape, its cells, and which displacements of its boundary are held.
struct BlockKind {
  Block shape;
  std::vector<const CellMatrix*> cells;  ///< row by row
  std::vector<bool> held;                ///< by unknown of the boundary
};

/// The stiffness of a block, with the nodes inside it eliminated (theory, Eq. 36). Held displacements are zero and have
/// a stiffness of their own.
class BlockStiffness {
 public:
  BlockStiffness(const BlockKind& kind, double stiffness_of_held);

  /// Nodes inside the block, row by row.
  [[nodiscard]] Eigen::Index inside() const noexcept { return factor_.rows(); }
  /// S = A_bb - A_bi A_ii^-1 A_ib
  [[nodiscard]] Eigen::MatrixXd condensed() const;
  /// A_bi A_ii^-1 f_i: what the boundary has to carry of forces inside.
  [[nodiscard]] Eigen::VectorXd carried_by_boundary(Eigen::VectorXd forces_inside) const;
  /// u_i = A_ii^-1 (f_i - A_ib u_b)
  [[nodiscard]] Eigen::VectorXd displacement_inside(Eigen::VectorXd forces_inside,
                                                    const Eigen::VectorXd& boundary) const;

 private:
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void factorise();
  template <class Rows>
  void solve_lower(Rows& right) const;
  void solve_upper(Eigen::VectorXd& right) const;

  Eigen::Index band_;         ///< non-zeros left of the diagonal
  RowMajor factor_;           ///< of A_ii: row i holds the columns i - band to i of the lower Cholesky factor
  RowMajor inside_boundary_;  ///< A_ib
  Eigen::MatrixXd boundary_;  ///< A_bb
};

}  // namespace breccia::quasistatic
