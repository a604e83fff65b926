#pragma once

#include <span>

#include "quasistatic/operator/elastic_operator.hpp"

namespace breccia::quasistatic {

/// The forces K u of a box of squares, by the stiffness matrix of each cell, under the displacement u = a E x + w, for
/// moduli [Pa] by material, which may be zero. E is the strain of the macroscopic part; without a strain the forces are
/// those under w alone. Forces on the held components of w are zero. The forces on the strains of phases are affine in
/// the moduli.
[[nodiscard]] Forces forces_under(const ElasticOperator<2>& elastic_operator, std::span<const Moduli> moduli,
                                  const Displacement& displacement, const Strain<2>& macroscopic_strain = {});

}  // namespace breccia::quasistatic
