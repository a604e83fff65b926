#pragma once

#include <map>
#include <string>
#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/study/tests.hpp"
#include "breccia/viscoelasticity/material.hpp"

#include "quasistatic/reduced/training_path.hpp"

namespace breccia {

/// The phases of a stage other than its matrix whose moduli vary in a reduced basis, by name: those that relax, and
/// those of elastic materials that the tests vary (Tests::varied).
std::map<std::string, Material> other_varying_phases(const Tests& tests, const Stage& stage);

/// All phases of a stage whose moduli vary: its matrix, then the other phases in the order of their names.
std::vector<VaryingPhase> varying_phases(const Tests& tests, const Stage& stage);

}  // namespace breccia
