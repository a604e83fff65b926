#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// The properties of grains and films on which the cost of a test depends (model "films").
struct FilmedGrains {
  double count = 0.0;
  double film = 0.0;  ///< in the plane, thickness of the films over the square root of the mean area of the cells [-]
  int dimensions = 2;
  double on_springs = 0.0;  ///< share of the films that are on springs [-]
};

/// The expected grains of a stage that is not packed yet, with the films that hexagons of their sizes would have.
FilmedGrains expected_grains(const Stage& stage);

/// The grains of a stage that is packed.
FilmedGrains placed_grains(const Stage& stage, const GrainStatistics& grains);

/// Approximate number of unknowns, displacements, flows and pressures, of a test of grains and films. Resolved films
/// have more unknowns the thinner they are. The formula is empirical.
double film_unknowns(const Tests& tests, const FilmedGrains& grains);

/// Approximate memory [B] of a test of grains and films; an empirical formula.
double film_memory(const Study& study, const Stage& stage, const FilmedGrains& grains);

/// Approximate processor time [s] of a test of grains and films, on a core like that of the measured costs; an
/// empirical formula.
double film_time(const Study& study, const Stage& stage, const FilmedGrains& grains);

}  // namespace breccia
