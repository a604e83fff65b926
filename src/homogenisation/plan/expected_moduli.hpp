#pragma once

#include <vector>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Moduli of particles and the share of the box that they fill [-].
struct ParticleShare {
  Moduli moduli;
  double fraction;
};

/// Moduli to be expected of elastic discs (`dimensions` 2, in plane strain) or spheres (3) in an elastic matrix, by the
/// differential scheme in which particles crowd (theory, Eq. 43j). Within 20 % of the logarithm of the stiffening in
/// the boxes with which it was compared.
Moduli expected_moduli(const Moduli& matrix, const std::vector<ParticleShare>& particles, int dimensions);

/// Moduli to be expected of a stage at a time [s], from those of its phases at that time (expected_moduli). Coatings
/// count as filler. For fillers with fractions alone.
Moduli expected_moduli(const Study& study, const Stage& stage, double time);

/// As expected_moduli(), of the matrix of a stage, which may be an earlier stage.
Moduli expected_moduli_of_matrix(const Study& study, const Stage& stage, double time);

}  // namespace breccia
