#pragma once

#include <span>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/moduli.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/viscoelasticity/material.hpp"

#include "quasistatic/reduced/training_path.hpp"

namespace breccia::quasistatic {

/// The stiffness of a composite as an affine function of the moduli p_i that vary, K(p) = K_0 + sum_i p_i K_i (theory,
/// Eq. 18a). Each part is given by a list of moduli by material: the part is the stiffness with these moduli.
struct AffineStiffness {
  struct Part {
    PhaseModulus parameter;    ///< phase and kind of the modulus p_i
    PhaseIndex phase;          ///< number of that phase
    std::vector<Moduli> unit;  ///< moduli of K_i, by material: 1 for this modulus of this phase, 0 for all others [-]
  };
  /// Moduli of K_0, by material: the moduli of the elastic phases [Pa]; 0 for those that vary.
  std::vector<Moduli> constant;
  std::vector<Part> parts;

  /// The moduli by material [Pa] with the stiffness K(p).
  [[nodiscard]] std::vector<Moduli> moduli_at(std::span<const double> parameters) const;
  /// The moduli by material [Pa] with the stiffness of the varying parts alone, sum_i p_i K_i.
  [[nodiscard]] std::vector<Moduli> varying_moduli_at(std::span<const double> parameters) const;
};

/// The affine stiffness of a composite in which both moduli of these phases vary, and all other materials are elastic.
/// Throws InputError, with every mistake, when there are no such phases, one of them is named twice or has no material,
/// or another material relaxes.
AffineStiffness affine_stiffness(const std::vector<Material>& materials, std::span<const VaryingPhase> varying);

}  // namespace breccia::quasistatic
