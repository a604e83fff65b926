#pragma once

#include <span>
#include <vector>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// Carson moduli s K~(s) and s G~(s) [Pa] of a material: the moduli of the corresponding elastic problem at a real
/// Laplace variable s [1/s], from 0 to infinity.
Moduli carson_moduli(const Material& material, double s);

/// Carson moduli of several materials at one Laplace variable.
struct CarsonPoint {
  double laplace_variable;     ///< s [1/s]: infinite for the unrelaxed moduli, 0 for those at equilibrium
  std::vector<Moduli> moduli;  ///< moduli by material [Pa]
};

/// Carson moduli [Pa] of a material from stiff to soft, for s from margin / window.begin to 1 / (margin window.end):
/// the training set of a reduced basis. The response of a composite at a time t depends on the Carson moduli of its
/// matrix near s = 1/t; moduli far from it have little influence.
std::vector<Moduli> carson_path(const Material& material, const TimeWindow& window, double margin = 30.0);
/// The joint path of several materials, at equal Laplace variables.
std::vector<CarsonPoint> carson_path(std::span<const Material> materials, const TimeWindow& window,
                                     double margin = 30.0);

/// Whether a matrix of these moduli is so soft in shear, compared with its bulk modulus, that softening it further
/// changes the modulus of a composite by a factor alone. Its solutions then serve for all softer matrices, too.
bool is_like_softer(const Moduli& moduli);

/// Carson moduli [Pa] of a material over its whole relaxation, from the unrelaxed moduli to those at equilibrium.
/// Without an equilibrium shear modulus the path ends in the flow regime, two decades of the Laplace variable beyond
/// the longest relaxation time, or at the end of carson_path() of the window if that is softer. Whatever its
/// temperature, the Carson moduli of the material lie on this path (theory, section 10).
std::vector<Moduli> relaxation_path(const Material& material, const TimeWindow& window);
/// The joint path of several materials at equal Laplace variables, from where none of them has relaxed to where all of
/// them have.
std::vector<CarsonPoint> relaxation_path(std::span<const Material> materials, const TimeWindow& window);

}  // namespace breccia
