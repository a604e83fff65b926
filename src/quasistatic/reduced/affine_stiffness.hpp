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
/// Eq. 18a). Each of the parts is given by the moduli by material of which it is the stiffness.
struct AffineStiffness {
  struct Part {
    PhaseModulus parameter;    ///< whose modulus p_i is
    PhaseIndex phase;          ///< the number of that phase
    std::vector<Moduli> unit;  ///< K_i, by material: 1 for this modulus of this phase, 0 for all others [-]
  };
  std::vector<Moduli> constant;  ///< K_0, by material: the moduli of the elastic phases [Pa]; 0 for those that vary
  std::vector<Part> parts;

  /// Moduli by material [Pa] whose stiffness is K(p).
  [[nodiscard]] std::vector<Moduli> moduli_at(std::span<const double> parameters) const;
  /// Moduli by material [Pa] whose stiffness is that of the parts that vary alone, sum_i p_i K_i.
  [[nodiscard]] std::vector<Moduli> varying_moduli_at(std::span<const double> parameters) const;
};

/// The affine stiffness of a composite in which both moduli of these phases vary, and all other materials are elastic.
/// Throws InputError, with every mistake, when there are no such phases, one of them is named twice or has no material,
/// or another material relaxes.
AffineStiffness affine_stiffness(const std::vector<Material>& materials, std::span<const VaryingPhase> varying);

}  // namespace breccia::quasistatic
