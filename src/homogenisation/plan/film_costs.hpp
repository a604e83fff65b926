#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Grains and films as far as the cost of a test depends on them (model "films").
struct FilmedGrains {
  double count = 0.0;
  double film = 0.0;  ///< thickness over the square root of the mean area of the cells [-]
};

/// The grains of a stage before they are placed, with the films that hexagons of their sizes would have.
FilmedGrains expected_grains(const Stage& stage);

/// The grains of a stage that are placed.
FilmedGrains placed_grains(const Stage& stage, const GrainStatistics& grains);

/// Approximate number of unknowns, displacements, flows and pressures, of a test of grains and films. Films that are
/// resolved have more of them the thinner they are. An empirical formula.
double film_unknowns(const Tests& tests, const FilmedGrains& grains);

/// Approximate memory [B] of a test of grains and films; an empirical formula.
double film_memory(const Study& study, const Stage& stage, const FilmedGrains& grains);

/// Approximate processor time [s] of such a test, on a core as that of the measured costs; an empirical formula.
double film_time(const Study& study, const Stage& stage, const FilmedGrains& grains);

}  // namespace breccia
