#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// The earlier stage whose result is the matrix of a stage; nullptr if its matrix is a material.
const Stage* stage_of_matrix(const Study& study, const Stage& stage);

/// The binder of a stage: its matrix if that is a material, or else the binder of the stage that is its matrix.
const Material& binder_of(const Study& study, const Stage& stage);

/// Whether the result of a stage is the matrix of another one. `Stages` is a list of objects that have a `matrix`
/// (StageMatrix).
template <class Stages>
bool serves_as_matrix(const Stages& stages, const std::string& stage) {
  return std::ranges::any_of(stages, [&stage](const auto& other) {
    const auto* earlier = std::get_if<EarlierStage>(&other.matrix);
    return earlier != nullptr && earlier->name == stage;
  });
}

/// The loads under which a stage is tested, each once: those of the study, and also shear and bulk as far as its result
/// as the matrix of a later stage, measured bulk or Young's moduli, or its thermal expansion need them.
std::vector<Load> loads_of(const Study& study, const Stage& stage);

/// The loads under which a stage is solved under a boundary by the quasi-static method: loads_of() and, where the whole
/// stiffness is asked for and the boundary prescribes strains, the pairs of loads from which it follows.
std::vector<Load> solved_loads(const Study& study, const Stage& stage, Boundary boundary);

/// The largest number of loads under which a stage is solved at a time, of all boundaries.
std::size_t most_solved_loads(const Study& study, const Stage& stage);

/// Whether the tests ask for the isotropic mean of all shears.
bool asks_for_isotropic(const Tests& tests);

/// The load whose modulus is G of a stage as a material.
TestLoad shear_of_material(const Tests& tests);

}  // namespace breccia
