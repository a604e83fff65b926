#pragma once

#include <span>
#include <vector>

#include "breccia/discretisation/load.hpp"
#include "breccia/films/film_fields.hpp"
#include "breccia/films/film_problem.hpp"
#include "breccia/progress.hpp"
#include "breccia/viscoelasticity/material.hpp"

#include "quasistatic/stepping/log_time_stepping.hpp"

namespace breccia {

class Checkpoint;

template <int dim>
struct FilmSteppingResult {
  std::vector<SteppedResponse> responses;    ///< responses by load
  std::vector<TimedFilmFields<dim>> fields;  ///< fields of the first load
  LinearEffort effort;
};

/// Steps elastic grains and films of this binder through time, as run_log_time_stepping() does for cells. It is the
/// reference for the reduced response (sample_film_responses). Each step makes new factors. Throws InputError when the
/// problem is not sound, there are no loads, or the times [s] are not positive and rising; NumericalError when a linear
/// system cannot be solved.
template <int dim>
[[nodiscard]] FilmSteppingResult<dim> run_film_stepping(const FilmProblem<dim>& problem, const Material& binder,
                                                        std::span<const Load> loads, std::span<const double> times,
                                                        const ProgressObserver& observer = {},
                                                        std::span<const double> field_times = {},
                                                        Checkpoint* checkpoint = nullptr);

}  // namespace breccia
