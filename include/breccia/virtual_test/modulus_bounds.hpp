#pragma once

#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Bounds on the shear modulus of a composite, those of Hashin (1965) in plane strain and those of Hashin and Shtrikman
/// (1963) in 3 dimensions, with the relaxation moduli of the phases used as elastic moduli (theory, Eq. 15 and 15a);
/// with voids, whose lower bound is 0, the lower one is an estimate.
/// They serve to plan runs; no result depends on them.
class ShearModulusBounds {
 public:
  /// Instantiated for 2 and 3 dimensions.
  template <int dim>
  ShearModulusBounds(const Discretisation<dim>& discretisation, const std::vector<Material>& materials);

  /// Lower bound [Pa] at a time [s]. With voids, of which the bound is 0, an estimate: the solid phase of the least
  /// moduli surrounds all others.
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

  /// The term that a medium with these moduli [Pa] adds to the shear modulus of a phase within it [Pa].
  double (*surrounding_)(double bulk, double shear);
  std::vector<Phase> phases_;
};

}  // namespace breccia
