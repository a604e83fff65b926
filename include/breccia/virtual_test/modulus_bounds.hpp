#pragma once

#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Bounds of Hashin (1965) on the in-plane shear modulus of a composite in plane strain, with the phases' relaxation
/// moduli taken as elastic ones (theory, Eq. 15). They plan runs; no result depends on them.
class ShearModulusBounds {
 public:
  ShearModulusBounds(const Discretisation<2>& discretisation, const std::vector<Material>& materials);

  /// [Pa], at a time [s].
  [[nodiscard]] double lower(double time) const;
  [[nodiscard]] double upper(double time) const;
  /// Between the two, in the geometric mean.
  [[nodiscard]] double estimate(double time) const;

 private:
  struct Phase {
    double fraction = 0.0;
    PronySeries bulk;
    PronySeries shear;
  };
  /// The composite if the medium around each phase had these moduli [Pa].
  [[nodiscard]] double surrounded_by(double bulk, double shear, double time) const;

  std::vector<Phase> phases_;
};

}  // namespace breccia
