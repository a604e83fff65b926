#pragma once

#include <vector>

#include "breccia/discretisation/point_fields.hpp"

#include "elastic_box.hpp"

namespace breccia::quasistatic {

/// The moduli of a material applied to the history of a displacement, the integral of M(t - t') du(t') [Pa]: for an
/// elastic one a multiple of the displacement. The stress of the material's points is that of these displacements under
/// unit moduli.
struct AppliedModuli {
  Field bulk, shear;
};

/// Fields of the points from the displacement of the nodes and, by material, what the stress answers to (theory, Eq.
/// 35). On the first process; on the others all is zero.
PointFields recover_fields(const ElasticBox& box, const Discretisation& discretisation, Volumetric volumetric,
                           Load load, const Field& displacement, const std::vector<AppliedModuli>& applied);

}  // namespace breccia::quasistatic
