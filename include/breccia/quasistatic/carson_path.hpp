#pragma once

#include <vector>

#include "breccia/discretisation/cell.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// Moduli s K~(s) and s G~(s) [Pa] that a material shows at a real Laplace variable s [1/s], its Carson moduli.
Moduli carson_moduli(const Material& material, double s);

/// Carson moduli [Pa] of a material, from stiff to soft, for s from margin / window.begin to 1 / (margin window.end).
/// The response of a composite at a time t depends on those of its matrix about s = 1/t, and fades away from it.
std::vector<Moduli> carson_path(const Material& material, const TimeWindow& window, double margin = 30.0);

/// Is a matrix of these moduli so soft in shear, relative to its bulk modulus, that a composite answers as it does with
/// any softer one but for a factor? Its solutions serve for all softer ones, and below that they are found no better.
bool is_like_softer(const Moduli& moduli);

/// Carson moduli [Pa] of a material over the whole of its relaxation, from stiff to soft: from the unrelaxed moduli to
/// those at equilibrium. Without an equilibrium shear modulus it ends where the material does little but flow, two
/// decades of the Laplace variable beyond the longest relaxation time, or with carson_path() of the window, whichever
/// is softer. The material at any temperature shows moduli of this path alone (theory, section 10).
std::vector<Moduli> relaxation_path(const Material& material, const TimeWindow& window);

}  // namespace breccia
