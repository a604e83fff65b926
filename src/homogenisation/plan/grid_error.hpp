#pragma once

#include <optional>

#include "breccia/discretisation/mixture.hpp"
#include "breccia/homogenisation/plan.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"
#include "breccia/virtual_test/curve.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// The rule for the cells in the narrowest gap of a stage without flow through it (theory, Eq. 43a).
ErrorRule error_rule_of_gaps(Mixing mixing);

/// The error of the interfaces of particles in series, in the plane, times the number of cells across the mean particle
/// (theory, Eq. 43l). It falls more slowly with finer cells than that of the gaps.
double error_of_interfaces(double fraction);

/// The rules for random packings with flow through the gaps between particles, by the number of cells across the
/// smallest one: of discs and ellipses in the plane, of polygons in the plane (theory, Eq. 43d), and of spheres
/// (Eq. 43e).
ErrorRule error_rule_of_discs();
ErrorRule error_rule_of_polygons();
ErrorRule error_rule_of_spheres_with_flow();

/// The rule for mixed cells across the films between grains, which carry the load of the whole stage (theory, Eq. 43b).
ErrorRule error_rule_of_films();

/// The rule for films between grains that are so narrow that the matrix flows through them (theory, Eq. 43f).
ErrorRule error_rule_of_narrow_films();

/// The rule for mixed cells and random packings of spheres that fill a fraction of the box [-], by the number of cells
/// across a sphere of the mean diameter, which is six times the whole volume over the whole surface (theory, Eq. 43c).
/// Returns nothing for fractions close to jamming.
std::optional<ErrorRule> error_rule_of_spheres(double fraction);

/// The steepest fall of a binder with which a rule for the error of a grid holds (theory, Eq. 43g).
inline constexpr double steepest_fall_with_rule = 2.0;

/// The steepest fall -d ln G / d ln t of a relaxation modulus in a window of times [-]; 0 for an elastic modulus.
double steepest_fall(const PronySeries& modulus, const TimeWindow& window);

/// The finest grid of a stage of particles or grains that is computed with cells; nothing where the number of cells
/// along no length gives its error. In the plane the cells across the smallest particle count where all fillers are
/// softer than the matrix. Errors grow with the steepest fall of the binder within the times of the tests (theory,
/// Eq. 43g). The plan names the reason where no rule holds: microstructures, materials or binders with which none was
/// measured.
std::optional<GridPlan> plan_of_grid(const Study& study, const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia
