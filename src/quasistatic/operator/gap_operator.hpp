#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include <Eigen/Core>

#include "discretisation/cell_shape.hpp"
#include "discretisation/gaps/gap_cells.hpp"
#include "quasistatic/operator/face_layout.hpp"

namespace breccia::quasistatic {

/// The cells with gaps of a discretisation, of which there are none in three dimensions.
template <int dim>
class GapsOfGrid {
 public:
  explicit GapsOfGrid(std::shared_ptr<const gaps::GapCells> cells = nullptr) : cells_(std::move(cells)) {}

  /// The gap cell at a cell of the grid; null for other cells.
  [[nodiscard]] const gaps::GapCell* at([[maybe_unused]] const Index<dim>& cell) const noexcept {
    if constexpr (dim == 2) return cells_ != nullptr ? cells_->at(cell) : nullptr;
    return nullptr;
  }
  /// All of them, if there are any.
  [[nodiscard]] const gaps::GapCells& cells() const noexcept { return *cells_; }
  /// Number of the unknowns of all faces.
  [[nodiscard]] std::int32_t unknowns() const noexcept { return cells_ != nullptr ? cells_->unknowns() : 0; }

 private:
  std::shared_ptr<const gaps::GapCells> cells_;
};

/// A cell with gaps as the elastic operator sees it. Its strain modes are those of CellShape, of which the last one,
/// the volume change, depends on the unknowns of its faces, too.
class GapOperator {
 public:
  using Shape = CellShape<2>;
  using Modes = Shape::ModeValues;
  using Unknowns = gaps::CellUnknowns;
  using Stiffness = Eigen::Matrix<double, gaps::unknowns_of_cell, gaps::unknowns_of_cell>;

  GapOperator(const gaps::GapCell& cell, const Shape::ModeMatrix& modes) : cell_(&cell), modes_(&modes) {}

  /// The unknowns from the displacements of the nodes and the values of faces (FaceLayout).
  [[nodiscard]] Unknowns unknowns(const Shape::Values& of_nodes, const FaceLayout& faces,
                                  std::span<const double> of_faces) const noexcept;
  [[nodiscard]] Modes strain(const Unknowns& unknowns) const noexcept;
  /// The volume change [-].
  [[nodiscard]] double volume(const Unknowns& unknowns) const noexcept { return cell_->volume.dot(unknowns); }
  /// The unknowns of a displacement with this gradient everywhere, without flow.
  [[nodiscard]] static Unknowns linear_motion(const Eigen::Matrix2d& gradient) noexcept;
  /// Adds the forces on the unknowns of stresses conjugate to the modes.
  void add_forces_of(const Modes& stress, Unknowns& forces) const noexcept;
  /// Adds the forces of the flow and of the ties of the slopes, for the moduli [Pa] of the phases.
  void add_forces_of_terms(std::span<const Moduli> moduli, const Unknowns& unknowns, Unknowns& forces) const noexcept;
  /// Adds forces to those on faces (FaceLayout).
  void add_to_faces(const Unknowns& forces, const FaceLayout& faces, std::span<double> on_faces) const noexcept;
  /// The stiffness for the moduli [Pa] of the cell and of the phases.
  [[nodiscard]] Stiffness stiffness(const Moduli& of_cell, std::span<const Moduli> moduli) const;

 private:
  const gaps::GapCell* cell_;
  const Shape::ModeMatrix* modes_;
};

}  // namespace breccia::quasistatic
