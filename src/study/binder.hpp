#pragma once

#include "breccia/study/study.hpp"

namespace breccia {

/// The earlier stage whose result is the matrix of a stage; null where its matrix is a material.
const Stage* stage_of_matrix(const Study& study, const Stage& stage);

/// The material at the bottom of a stage: its matrix, or the binder of the stage that is its matrix.
const Material& binder_of(const Study& study, const Stage& stage);

}  // namespace breccia
