#pragma once

namespace breccia {

/// Small strain in the plane (plane strain: the out-of-plane strain is zero). The shear is the tensor component,
/// half of the engineering shear.
struct PlaneStrain {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;

  friend bool operator==(const PlaneStrain&, const PlaneStrain&) = default;
};

/// Stress in plane strain, tension positive [Pa].
struct PlaneStress {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;

  friend bool operator==(const PlaneStress&, const PlaneStress&) = default;
};

}  // namespace breccia
