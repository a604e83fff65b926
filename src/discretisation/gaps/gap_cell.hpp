#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "breccia/discretisation/mixture.hpp"
#include "breccia/discretisation/phase.hpp"

#include "discretisation/cell_shape.hpp"
#include "discretisation/mixture_rule.hpp"

namespace breccia::gaps {

template <int dim>
inline constexpr int faces_of_cell = 2 * dim;

/// The unknowns of gaps in a cell: the flows through its faces, and slopes of displacements in its particles. In the
/// plane each face has a flow and two slopes (plane/face_unknowns.hpp); in space the slopes belong to the nodes
/// (space/cube_unknowns.hpp).
template <int dim>
inline constexpr int gap_unknowns_of_cell = dim == 2 ? 12 : 54;

/// The unknowns of a cell with gaps: the displacements of its nodes, in the order of CellShape, and those of its gaps.
template <int dim>
inline constexpr int unknowns_of_cell = CellShape<dim>::dofs + gap_unknowns_of_cell<dim>;
template <int dim>
using CellUnknowns = Eigen::Matrix<double, unknowns_of_cell<dim>, 1>;

/// Number in its cell of the displacement of a node along an axis.
template <int dim>
[[nodiscard]] constexpr int displacement_of(int node, std::size_t axis) noexcept {
  return dim * node + static_cast<int>(axis);
}

/// A linear form of a few unknowns of a cell.
template <int dim>
class LinearForm {
 public:
  LinearForm& add(int unknown, double weight) {
    parts_.push_back({static_cast<std::uint8_t>(unknown), weight});
    return *this;
  }
  LinearForm& add(double factor, const LinearForm& other) {
    for (const auto& [unknown, weight] : other.parts_) add(unknown, factor * weight);
    return *this;
  }
  [[nodiscard]] bool is_empty() const noexcept { return parts_.empty(); }
  [[nodiscard]] double of(const CellUnknowns<dim>& unknowns) const noexcept {
    double value = 0.0;
    for (const auto& [unknown, weight] : parts_) value += weight * unknowns[unknown];
    return value;
  }
  /// Calls action(unknown, weight) for each part.
  template <class Action>
  void for_parts(const Action& action) const {
    for (const auto& [unknown, weight] : parts_) action(unknown, weight);
  }
  /// Adds a multiple of the form's weights.
  void add_to(CellUnknowns<dim>& forces, double factor) const noexcept {
    for (const auto& [unknown, weight] : parts_) forces[unknown] += factor * weight;
  }

 private:
  struct Part {
    std::uint8_t unknown;
    double weight;
  };
  std::vector<Part> parts_;
};

/// An energy per volume of a cell: half of the shear modulus of a phase, times a factor, times the square of a form.
template <int dim>
struct SquareTerm {
  PhaseIndex phase = 0;
  double factor = 0.0;
  LinearForm<dim> form;
};

/// A cell that the surface of a particle crosses, or on whose faces there is binder (theory, Eqs. 42c to 42h;
/// docs/gaps-in-space.md). Its deviators are those of its nodes; its phases are in series.
template <int dim>
struct GapCell {
  Mixture mixture;                     ///< its phases, with their shares of its volume
  std::vector<VolumeAndShear> shares;  ///< the shares of these phases in series, which need not add up to 1
  CellUnknowns<dim> volume = {};       ///< the form of the volume change, without what flows out
  std::vector<SquareTerm<dim>> terms;
  /// The number of each unknown of its gaps among those of all cells; none for one that the cell does not have.
  std::array<std::int32_t, gap_unknowns_of_cell<dim>> gap_unknowns = {};
  static constexpr std::int32_t none = -1;
};

}  // namespace breccia::gaps
