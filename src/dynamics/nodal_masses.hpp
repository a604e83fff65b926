#pragma once

#include <vector>

#include "breccia/dynamics/dynamic_problem.hpp"

namespace breccia::dynamics {

/// Lumped masses of the nodes per unit thickness [kg/m], times the density factor, row by row: m_I = sum_p w_Ip m_p.
/// Nodes of a periodic box that are one have the mass of all of them.
std::vector<double> nodal_masses(const DynamicProblem& problem);

}  // namespace breccia::dynamics
