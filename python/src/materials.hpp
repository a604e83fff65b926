#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "breccia/viscoelasticity/creep_compliance.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/prony_series.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia::python {

/// Adds Prony series, creep compliances, and materials as solvers take them, to the module.
void bind_materials(pybind11::module_& module);

// The content of a series for pickle: (equilibrium modulus, relaxation times, moduli).
pybind11::tuple state_of(const PronySeries& series);
PronySeries series_from(const pybind11::tuple& state);
// The content of a creep compliance for pickle: (instantaneous compliance, retardation times, compliances, fluidity).
pybind11::tuple state_of(const CreepCompliance& compliance);
CreepCompliance compliance_from(const pybind11::tuple& state);
// The content of a material for pickle.
pybind11::tuple state_of(const Material& material);
Material material_from(const pybind11::tuple& state);

/// The materials without the laws of their temperature shift.
std::vector<Material> without_shifts(const std::vector<ShiftedMaterial>& materials);

}  // namespace breccia::python
