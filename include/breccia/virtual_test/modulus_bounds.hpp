#pragma once

#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Bounds of Hashin (1965) on the in-plane shear modulus of a composite in plane strain, with the relaxation moduli of
/// the phases used as elastic moduli (theory, Eq. 15). They serve to plan runs; no result depends on them.
class ShearModulusBounds {
 public:
  ShearModulusBounds(const Discretisation<2>& discretisation, const std::vector<Material>& materials);

  /// Lower bound [Pa] at a time [s].
  [[nodiscard]] double lower(double time) const;
  /// Upper bound [Pa] at a time [s].
  [[nodiscard]] double upper(double time) const;
  /// Geometric mean of the bounds [Pa] at a time [s].
  [[nodiscard]] double estimate(double time) const;

 private:
  struct Phase {
    double fraction = 0.0;
    PronySeries bulk;
    PronySeries shear;
  };
  /// Shear modulus [Pa] of the composite if the medium around each phase had these moduli [Pa].
  [[nodiscard]] double surrounded_by(double bulk, double shear, double time) const;

  std::vector<Phase> phases_;
};

}  // namespace breccia
