#pragma once

#include "breccia/discretisation/boundary.hpp"
#include "breccia/homogenisation/film_estimate.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// What one of several processes takes, each of which has one thread and a core of its own.
struct ProcessShare {
  double bytes = 0.0;         ///< memory of the largest process [B]
  double seconds = 0.0;       ///< wall time [s]
  double common_bytes = 0.0;  ///< memory that the processes of a machine have in common, beside theirs [B]
};

/// Of a quasi-static test of all loads of a stage under one boundary, on a grid with `cells` cells per side: a model of
/// measured parts (docs/performance.md, "Several processes"). On one process both parts of the memory are
/// quasistatic_memory(), and the time is quasistatic_time().
ProcessShare quasistatic_share(const Study& study, const Stage& stage, Boundary boundary, int cells, int processes);

/// The same of a test of grains and films.
ProcessShare film_share(const Study& study, const Stage& stage, const FilmedGrains& grains, int processes);

/// Of a dynamic test of the total-lagrangian formulation in so many dimensions, with `cells` cells per side, that takes
/// so many bytes and seconds on one process.
ProcessShare dynamic_share(int dimensions, int cells, double bytes, double seconds, int processes);

/// The same of the classical formulation, of which every process runs the whole.
ProcessShare classical_share(int dimensions, int cells, double bytes, double seconds);

}  // namespace breccia
