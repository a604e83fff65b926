#pragma once

#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// The earlier stage whose result is the matrix of a stage; null where its matrix is a material.
const Stage* stage_of_matrix(const Study& study, const Stage& stage);

/// The material at the bottom of a stage: its matrix, or the binder of the stage that is its matrix.
const Material& binder_of(const Study& study, const Stage& stage);

/// Does a later stage take the result of this one as its matrix?
bool serves_as_matrix(const Study& study, const Stage& stage);

/// The loads under which a stage is tested: those of the study, and shear and bulk where the result serves as a matrix.
std::vector<Load> loads_of(const Study& study, const Stage& stage);

}  // namespace breccia
