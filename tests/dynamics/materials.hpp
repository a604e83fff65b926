#pragma once

#include <array>
#include <utility>
#include <vector>

#include "breccia/discretisation/discretisation.hpp"
#include "breccia/viscoelasticity/material.hpp"

#include "discretisation/mixed_cells.hpp"
#include "dynamics/dynamic_problem.hpp"

namespace breccia::testing_materials {

inline const Material soft = {"soft", 1000.0, PronySeries(3e6), PronySeries(1e6)};
inline const Material stiff = {"stiff", 1700.0, PronySeries(40e6), PronySeries(25e6)};
inline const Material relaxing = {"relaxing", 1200.0, PronySeries(2e6, {{3e-3, 4e6}}),
                                  PronySeries(0.1e6, {{1e-3, 2e6}, {2e-2, 1e6}})};

/// A solid with the given equilibrium moduli [Pa], damped by a Maxwell element.
inline Material damped(double bulk, double shear) {
  return {"damped", 1000.0, PronySeries(bulk), PronySeries(shear, {{0.03, 2.0 * shear}})};
}

/// A disc of material 1 in a box of material 0 with side 1 m.
inline Discretisation<2> disc_in_box(int cells) {
  return discretise<2>({1.0, Walls::hard, {Disc{{0.45, 0.52}, 0.61}}}, cells, 0, 1);
}

/// A sphere of material 1 in a box of material 0 with side 1 m.
inline Discretisation<3> sphere_in_box(int cells) {
  return discretise<3>({1.0, Walls::hard, {Ball<3>{{0.45, 0.52, 0.47}, 0.71}}}, cells, 0, 1);
}

/// A sphere of material 1 in a box of material 0 with mixed cells, and the materials of the phases and of their
/// mixtures.
inline DynamicProblem<3> mixed_sphere_in_box(int cells, std::vector<Material> materials) {
  constexpr std::array<PhaseIndex, 1> sphere = {1};
  const Microstructure<3> microstructure = {1.0, Walls::hard, {Ball<3>{{0.45, 0.52, 0.47}, 0.71}}};
  auto box = discretise_mixed<3>(microstructure, cells, 0, sphere, materials.size());
  auto all = with_mixtures(box, std::move(materials));
  return {std::move(box), std::move(all)};
}

/// A problem at a share of its stable time step.
template <int dim>
DynamicProblem<dim> with_step(DynamicProblem<dim> problem, double courant = 0.9) {
  problem.time_step =
      courant * stable_time_step(problem.discretisation, problem.materials, problem.volumetric, problem.mass_scaling);
  return problem;
}

}  // namespace breccia::testing_materials
