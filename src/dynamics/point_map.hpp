#pragma once

// The map P from the strain modes of a cell to the strain of one of its material points, and its transpose P', by which
// the stress of the point does work on the modes (theory, Eq. 6 and 73). The map is written for single numbers and for
// registers of several cells: everything here has internal linkage and uses nothing of the standard library (see
// kernel_registers.hpp).

#include "dynamics/cell_row_kernel.hpp"

#define BRECCIA_INLINE inline __attribute__((always_inline))

namespace breccia::dynamics {
namespace {  // NOLINT(google-build-namespaces): see above

template <int dim>
constexpr int points_of_cell = 1 << dim;

/// Bit d of the number of a point says whether it lies on the upper side along axis d. Modes are in the order of
/// shear_modes and bulk_modes_standard; strains and stresses are in Voigt's order, with engineering shears.
template <int dim>
class PointMap;

/// Numbers of the strain modes of a square: of its centre in Voigt's order; the hourglass modes, the gradients of the
/// two components of the displacement along the diagonal.
struct SquareMode {
  enum Number { xx, yy, xy, qu, qv };
};

template <>
class PointMap<2> {
 public:
  BRECCIA_INLINE explicit PointMap(int point)
      : x_((point & 1) != 0 ? 0.25 : -0.25), y_((point & 2) != 0 ? 0.25 : -0.25) {}

  /// Averaged points have the mean of the volumetric strain, half of it in each direction.
  template <bool averaged, class Number>
  BRECCIA_INLINE void find_strain(const Number* modes, Number* strain) const {
    const Number &qu = modes[SquareMode::qu], &qv = modes[SquareMode::qv];
    const Number along_x = averaged ? 0.5 * (y_ * qu - x_ * qv) : y_ * qu;
    const Number along_y = averaged ? -along_x : x_ * qv;
    strain[0] = modes[0] + along_x;
    strain[1] = modes[1] + along_y;
    strain[2] = modes[2] + x_ * qu + y_ * qv;
  }

  /// The deviatoric stress, where the shear modulus has been applied to the modes.
  template <bool averaged, class Number>
  BRECCIA_INLINE void find_deviator(const Number* modes, Number* stress) const {
    Number strain[3];  // NOLINT(modernize-avoid-c-arrays): nothing of the standard library here
    find_strain<averaged>(modes, strain);
    stress[0] = (4.0 / 3.0) * strain[0] - (2.0 / 3.0) * strain[1];
    stress[1] = (4.0 / 3.0) * strain[1] - (2.0 / 3.0) * strain[0];
    stress[2] = strain[2];
  }

  /// The volumetric strain, or the pressure where the bulk modulus has been applied to the volumetric modes.
  template <bool averaged, class Number>
  [[nodiscard]] BRECCIA_INLINE Number volume(const Number* modes) const {
    if constexpr (averaged) return modes[0];
    return modes[0] + y_ * modes[1] + x_ * modes[2];
  }

  /// Adds the forces on the modes. The pressure of averaged points does no work on hourglass modes.
  template <bool averaged, class Number>
  BRECCIA_INLINE void add_forces(const Number* deviator, const Number& pressure, Number* forces) const {
    const Number &xx = deviator[0], &yy = deviator[1], &xy = deviator[2];
    forces[SquareMode::xx] += pressure + xx;
    forces[SquareMode::yy] += pressure + yy;
    forces[SquareMode::xy] += xy;
    forces[SquareMode::qu] += y_ * (averaged ? 0.5 * (xx - yy) : pressure + xx) + x_ * xy;
    forces[SquareMode::qv] += x_ * (averaged ? 0.5 * (yy - xx) : pressure + yy) + y_ * xy;
  }

 private:
  double x_, y_;  ///< position of the point relative to the centre, in cell sides
};

/// Numbers of the strain modes of a cube: of its centre in Voigt's order; the twists [c][d], the gradient of the
/// component c of the displacement across d along both of the other axes; the warps [c], that along all axes.
struct CubeMode {
  static constexpr int axes = 3;

  static constexpr int twist(int c, int d) { return 2 * axes + axes * c + d; }
  static constexpr int warp(int c) { return 5 * axes + c; }
};

template <>
class PointMap<3> {
 public:
  // NOLINTBEGIN(modernize-avoid-c-arrays): nothing of the standard library here
  BRECCIA_INLINE explicit PointMap(int point)
      : sign_{(point & 1) != 0 ? 1.0 : -1.0, (point & 2) != 0 ? 1.0 : -1.0, (point & 4) != 0 ? 1.0 : -1.0},
        pair_{sign_[1] * sign_[2], sign_[2] * sign_[0], sign_[0] * sign_[1]} {}

  /// The strain of the point. Averaged volumetric strains change its volumetric part alone, which is not used: that
  /// part is volume().
  template <bool averaged, class Number>
  BRECCIA_INLINE void find_strain(const Number* modes, Number* strain) const {
    Number gradient[axes][axes];
    find_gradient(modes, gradient);
    for (int c = 0; c < axes; ++c) {
      const int d = (c + 1) % axes, e = (c + 2) % axes;
      strain[c] = modes[c] + gradient[c][c];
      strain[axes + c] = modes[axes + c] + gradient[d][e] + gradient[e][d];
    }
  }

  /// The deviatoric stress, where the shear modulus has been applied to the modes.
  template <bool averaged, class Number>
  BRECCIA_INLINE void find_deviator(const Number* modes, Number* stress) const {
    Number gradient[axes][axes];
    find_gradient(modes, gradient);
    const Number volume = ((modes[0] + modes[1]) + modes[2]) + ((gradient[0][0] + gradient[1][1]) + gradient[2][2]);
    for (int c = 0; c < axes; ++c) {
      const int d = (c + 1) % axes, e = (c + 2) % axes;
      stress[c] = 2.0 * (modes[c] + gradient[c][c]) - (2.0 / 3.0) * volume;
      stress[axes + c] = modes[axes + c] + gradient[d][e] + gradient[e][d];
    }
  }

  /// The volumetric strain, or the pressure where the bulk modulus has been applied to the volumetric modes: of the
  /// centre, along each axis, and along each pair of axes, numbered by the third.
  template <bool averaged, class Number>
  [[nodiscard]] BRECCIA_INLINE Number volume(const Number* modes) const {
    Number volume = modes[0];
    if constexpr (!averaged) {
      for (int c = 0; c < axes; ++c) volume += sign_[c] * modes[1 + c] + pair_[c] * modes[1 + axes + c];
    }
    return volume;
  }

  /// Adds the forces on the modes. The pressure of averaged points does no work on hourglass modes.
  template <bool averaged, class Number>
  BRECCIA_INLINE void add_forces(const Number* deviator, const Number& pressure, Number* forces) const {
    Number stress[axes][axes];
    for (int c = 0; c < axes; ++c) {
      const int d = (c + 1) % axes, e = (c + 2) % axes;
      stress[c][c] = deviator[c];
      stress[d][e] = stress[e][d] = deviator[axes + c];
    }
    for (int c = 0; c < axes; ++c) {
      forces[c] += stress[c][c] + pressure;
      forces[axes + c] += stress[(c + 1) % axes][(c + 2) % axes];
      if constexpr (!averaged) stress[c][c] += pressure;
    }
    for (int c = 0; c < axes; ++c) {
      for (int d = 0; d < axes; ++d) {
        const int e = (d + 1) % axes, f = (d + 2) % axes;
        forces[CubeMode::twist(c, d)] += sign_[f] * stress[c][e] + sign_[e] * stress[c][f];
        forces[CubeMode::warp(c)] += pair_[d] * stress[c][d];
      }
    }
  }

 private:
  static constexpr int axes = CubeMode::axes;

  /// Gradient [c][d] of the component c along d, without that of the centre.
  template <class Number>
  BRECCIA_INLINE void find_gradient(const Number* modes, Number (*gradient)[axes]) const {
    for (int c = 0; c < axes; ++c) {
      for (int d = 0; d < axes; ++d) {
        const int e = (d + 1) % axes, f = (d + 2) % axes;
        gradient[c][d] = (sign_[e] * modes[CubeMode::twist(c, f)] + sign_[f] * modes[CubeMode::twist(c, e)]) +
                         pair_[d] * modes[CubeMode::warp(c)];
      }
    }
  }

  double sign_[axes];  ///< signs of the position of the point along the axes
  double pair_[axes];  ///< products of the signs of two axes, numbered by the third
  // NOLINTEND(modernize-avoid-c-arrays)
};

}  // namespace
}  // namespace breccia::dynamics
