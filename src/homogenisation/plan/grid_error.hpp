#pragma once

#include <optional>

#include "breccia/discretisation/mixture.hpp"
#include "breccia/homogenisation/plan.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/virtual_test/curve.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// The rule for the cells in the narrowest gap of a stage without flow through it (theory, Eq. 43a).
ErrorRule error_rule_of_gaps(Mixing mixing);

/// The rule for random packings of discs or spheres with flow through the gaps between them, by the number of cells
/// across the smallest one (theory, Eqs. 43d and 43e).
ErrorRule error_rule_of_flow(int dimensions);

/// The rule for mixed cells across the films between grains, which carry the load of the whole stage (theory, Eq. 43b).
ErrorRule error_rule_of_films();

/// The rule for mixed cells and random packings of spheres that fill a fraction of the box [-], by the number of cells
/// across a sphere of the mean diameter, which is six times the whole volume over the whole surface (theory, Eq. 43c).
/// Returns nothing for fractions close to jamming.
std::optional<ErrorRule> error_rule_of_spheres(double fraction);

/// The steepest fall -d ln G / d ln t of a relaxation modulus in a window of times [-]. The relative error of a modulus
/// that falls faster than 1/t is larger by this factor (theory, Eq. 43f); for an elastic modulus it is 0.
double steepest_fall(const PronySeries& modulus, const TimeWindow& window);

/// The finest grid of a stage of particles or grains that is computed with cells; nothing where no rule applies to its
/// error.
std::optional<GridPlan> plan_of_grid(const Stage& stage, const StageMicrostructure& packed, Mixing mixing);

}  // namespace breccia
