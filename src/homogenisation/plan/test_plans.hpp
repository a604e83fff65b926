#pragma once

#include <vector>

#include "breccia/homogenisation/plan.hpp"
#include "breccia/homogenisation/stage_microstructure.hpp"

namespace breccia {

/// The plan of the quasi-static test of all loads of a stage under one boundary, on a grid with `cells` cells per side.
TestPlan plan_of_quasistatic_test(const Study& study, const Stage& stage, Boundary boundary, int cells);

/// The plan of the test of all loads of a stage under one boundary by the model of grains and films.
TestPlan plan_of_film_test(const Study& study, const Stage& stage, Boundary boundary, const GrainStatistics& grains);

/// The plans of the dynamic tests of a packed stage, each under one boundary and load, on a grid with `cells` cells per
/// side. Throws NumericalError where time domains do not cover the times.
std::vector<TestPlan> plans_of_dynamic_tests(const Study& study, const Stage& stage, const StageMicrostructure& packed,
                                             int cells);

/// Memory [B] of the largest dynamic test of a stage, which need not be packed, on a grid with `cells` cells per side.
double memory_of_dynamic_tests(const Study& study, const Stage& stage, int cells);

}  // namespace breccia
