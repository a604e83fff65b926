#pragma once

#include <optional>

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// Two of the four elastic constants of an isotropic solid. Each of them except Poisson's ratio may relax.
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

/// The bulk and the shear modulus that two of the constants determine, exactly (theory, Eq. 23c). Throws InputError
/// where they do not describe a solid (with both moduli above zero), and for a relaxing Young's modulus with a relaxing
/// bulk modulus or with a shear modulus, because the third constant is then an ill-conditioned difference.
BulkAndShear bulk_and_shear(const TwoModuli& given);

}  // namespace breccia
