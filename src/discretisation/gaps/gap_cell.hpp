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

/// The unknowns of a cell with gaps are the displacements of its nodes, in the order of CellShape, and three of each of
/// its faces: left, right, lower and upper.
inline constexpr int faces_of_cell = 4, unknowns_of_face = 3, unknowns_of_faces = faces_of_cell * unknowns_of_face;
inline constexpr int unknowns_of_cell = CellShape<2>::dofs + unknowns_of_faces;
using CellUnknowns = Eigen::Matrix<double, unknowns_of_cell, 1>;

/// Number of an unknown in its cell: the displacement of a node along an axis, the flow through a face along its normal
/// (in units of Face::unit_of_flow), and the slope of the displacement along the normal in the particle of the first or
/// second node of a face.
[[nodiscard]] constexpr int displacement_of(int node, std::size_t axis) noexcept {
  return 2 * node + static_cast<int>(axis);
}
[[nodiscard]] constexpr int flow_through(int face) noexcept {
  return CellShape<2>::dofs + unknowns_of_face * face;
}
[[nodiscard]] constexpr int slope_at(int face, int end) noexcept {
  return flow_through(face) + 1 + end;
}

/// A linear form of a few unknowns of a cell.
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
  [[nodiscard]] double of(const CellUnknowns& unknowns) const noexcept {
    double value = 0.0;
    for (const auto& [unknown, weight] : parts_) value += weight * unknowns[unknown];
    return value;
  }
  /// Adds a multiple of the form's weights.
  void add_to(CellUnknowns& forces, double factor) const noexcept {
    for (const auto& [unknown, weight] : parts_) forces[unknown] += factor * weight;
  }

 private:
  struct Part {
    std::uint8_t unknown;
    double weight;
  };
  std::vector<Part> parts_;
};

/// An energy per area of a cell: half of the shear modulus of a phase, times a factor, times the square of a form.
struct SquareTerm {
  PhaseIndex phase = 0;
  double factor = 0.0;
  LinearForm form;
};

/// A cell that the surface of a particle crosses, or on whose faces there is binder (theory, Eqs. 42c to 42h). Its
/// deviators are those of its nodes; its phases are in series.
struct GapCell {
  Mixture mixture;                     ///< its phases, with their shares of its area
  std::vector<VolumeAndShear> shares;  ///< the shares of these phases in series, which need not add up to 1
  CellUnknowns volume = {};            ///< the form of the volume change, without what flows out
  std::vector<SquareTerm> terms;
  /// The number of each unknown of its faces among those of all faces; none for one that the face does not have.
  std::array<std::int32_t, unknowns_of_faces> face_unknowns = {};
  static constexpr std::int32_t none = -1;
};

}  // namespace breccia::gaps
