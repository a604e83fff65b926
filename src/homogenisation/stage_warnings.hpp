#pragma once

#include <string>
#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Warnings about a stage that are known before its tests. Warnings that name the stage are about: a gap that depends
/// on the grid, particles too close in size to those of its matrix, gaps that the grid does not resolve, grains that
/// the films take up for the most part, particles that a boundary cuts, times outside the spectrum of its matrix.
/// Warnings that name a material are about materials that no earlier stage has, such as an unusual Poisson's ratio.
std::vector<std::string> warnings_on(const Study& study, const Stage& stage, const StageMicrostructure& microstructure);

}  // namespace breccia
