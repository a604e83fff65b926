#pragma once

#include <map>

#include "breccia/discretisation/point_fields.hpp"

#include "quasistatic/operator/elastic_operator.hpp"

namespace breccia::quasistatic {

/// The bulk and the shear modulus M of a material applied to the history of the displacement, the Stieltjes integral of
/// M(t - t') du(t') [Pa]; for an elastic material M u. The stress at its points is that of these two displacements with
/// unit moduli.
struct AppliedModuli {
  Displacement bulk, shear;
};

/// Displacement, strain and stress at the material points of a square (PointFields), or their means over the cells of a
/// cube (CellFields), from the displacement of the nodes and from the moduli applied to its history, by isotropic phase
/// (theory, Eq. 35); the stress of a crystal is its stiffness times the strain. In a cell with gaps the volume change
/// is that of its faces, and the stress has the mean that is conjugate to a uniform strain of nodes and slopes. The
/// fields are those of the cells of this process. Instantiated for 2 and 3 dimensions.
template <int dim>
[[nodiscard]] LatticeFields<dim> recover_fields(const ElasticOperator<dim>& elastic_operator,
                                                const Discretisation<dim>& discretisation, Volumetric volumetric,
                                                Load load, const Displacement& displacement,
                                                const std::map<PhaseIndex, AppliedModuli>& applied,
                                                const Crystals& crystals = {});

}  // namespace breccia::quasistatic
