#pragma once

#include <array>
#include <vector>

#include "breccia/discretisation/moduli.hpp"

namespace breccia::quasistatic {

/// Sine and cosine of half the phase angle of a wave from node to node along an axis.
struct HalfAngle {
  double sine, cosine;
};

/// Half angles of `count` waves along an axis, which are `step` [rad] apart, from zero.
[[nodiscard]] std::vector<HalfAngle> half_angles(int count, double step);

/// The symbol of the elastic operator of equal cubic cells, with averaged volumetric strains: its action on waves of
/// the nodal displacements, G T + K d d', where d is the divergence of the wave and the symmetric matrix T the shear
/// (theory, Eq. 72). The same real numbers hold for plane waves and for products of sines and cosines.
class WaveSymbol {
 public:
  WaveSymbol(const HalfAngle& x, const HalfAngle& y, const HalfAngle& z) noexcept
      : divergence_{2.0 * x.sine * y.cosine * z.cosine, 2.0 * x.cosine * y.sine * z.cosine,
                    2.0 * x.cosine * y.cosine * z.sine},
        xy_(x.sine * y.sine * z.cosine),
        yz_(x.cosine * y.sine * z.sine),
        zx_(x.sine * y.cosine * z.sine),
        xyz_(0.5 * x.sine * y.sine * z.sine) {}

  /// The symbol of the Laplacian of one component.
  [[nodiscard]] double laplacian() const noexcept {
    const auto& [x, y, z] = divergence_;
    return x * x + y * y + z * z + 2.0 * (xy_ * xy_ + yz_ * yz_ + zx_ * zx_) + 3.0 * xyz_ * xyz_;
  }

  /// The waves of the displacement under waves of forces that are divided by the shear modulus; `ratio` is K/G. Value
  /// is a real or a complex number. The symbol must not be zero, as it is for equal displacements of all nodes.
  template <class Value>
  [[nodiscard]] std::array<Value, 3> displacement(const std::array<Value, 3>& forces, double ratio) const noexcept {
    const auto& [x, y, z] = divergence_;
    // The matrix T is the identity times the Laplacian plus a third of the products of each gradient.
    constexpr double third = 1.0 / 3.0;
    const double equal = laplacian() + third * xyz_ * xyz_;
    const double xx = equal + third * (x * x + xy_ * xy_ + zx_ * zx_);
    const double yy = equal + third * (y * y + xy_ * xy_ + yz_ * yz_);
    const double zz = equal + third * (z * z + yz_ * yz_ + zx_ * zx_);
    const double xy = third * (x * y + zx_ * yz_), yz = third * (y * z + xy_ * zx_), zx = third * (z * x + xy_ * yz_);
    // The inverse of T times its determinant.
    const double i_xx = yy * zz - yz * yz, i_yy = zz * xx - zx * zx, i_zz = xx * yy - xy * xy;
    const double i_xy = yz * zx - xy * zz, i_yz = zx * xy - yz * xx, i_zx = xy * yz - zx * yy;
    const double inverse = 1.0 / (xx * i_xx + xy * i_xy + zx * i_zx);
    // The formula of Sherman and Morrison for K d d'.
    const double p_x = inverse * (i_xx * x + i_xy * y + i_zx * z), p_y = inverse * (i_xy * x + i_yy * y + i_yz * z),
                 p_z = inverse * (i_zx * x + i_yz * y + i_zz * z);
    const auto& [f_x, f_y, f_z] = forces;
    const double share = ratio / (1.0 + ratio * (x * p_x + y * p_y + z * p_z));
    const Value pressure = share * (p_x * f_x + p_y * f_y + p_z * f_z);
    return {inverse * (i_xx * f_x + i_xy * f_y + i_zx * f_z) - p_x * pressure,
            inverse * (i_xy * f_x + i_yy * f_y + i_yz * f_z) - p_y * pressure,
            inverse * (i_zx * f_x + i_yz * f_y + i_zz * f_z) - p_z * pressure};
  }

 private:
  std::array<double, 3> divergence_;
  double xy_, yz_, zx_, xyz_;  ///< gradients that change sign in the cell
};

}  // namespace breccia::quasistatic
