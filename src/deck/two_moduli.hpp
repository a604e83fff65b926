#pragma once

#include <optional>

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// Two of the four elastic constants of an isotropic solid, each of which may relax but for Poisson's ratio.
struct TwoModuli {
  std::optional<PronySeries> bulk = {};
  std::optional<PronySeries> shear = {};
  std::optional<PronySeries> young = {};
  std::optional<double> poisson = {};
};

/// The bulk and the shear modulus of the solid [Pa].
struct BulkAndShear {
  PronySeries bulk;
  PronySeries shear;
};

/// The bulk and the shear modulus that two of the constants determine, exactly (theory, Eq. 23c). Throws
/// InputError where they are not of a solid (both moduli above zero), and for a relaxing Young's modulus with a
/// relaxing bulk modulus or with a shear modulus, of which the third is an ill-conditioned difference.
BulkAndShear bulk_and_shear(const TwoModuli& given);

}  // namespace breccia
