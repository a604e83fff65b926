#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "breccia/discretisation/load.hpp"
#include "breccia/films/film_fields.hpp"
#include "breccia/films/film_problem.hpp"
#include "breccia/progress.hpp"
#include "breccia/quasistatic/reduced_response.hpp"

#include "quasistatic/reduced/sampling.hpp"
#include "quasistatic/reduced/target_curve.hpp"

namespace breccia {

class Checkpoint;

template <int dim>
struct FilmResponses {
  /// Fields per unit load at a time [s] after a load was applied to grains with this binder. `load` is the index in the
  /// list of loads. Throws InputError unless there is one binder.
  using Recovery = std::function<FilmFields<dim>(std::size_t load, std::span<const Material> binder, double time)>;

  std::vector<ReducedResponse> responses;  ///< responses by load
  LinearEffort effort;
  Recovery fields;  ///< function that computes fields and owns the vectors of the basis
};

/// Builds a reduced response of grains and films for each load, as sample_responses() does for cells; the moduli of the
/// binder, which is the matrix, are its parameters. `training_set` are moduli [Pa] of the binder from stiff to soft
/// (carson_path(), relaxation_path()); `target` is the curve of a binder for which the curve in time must meet the
/// tolerance, too. All functions for the responses of cells take these responses as well: creep_compliance(), exact in
/// time for a Prony series, coverage(), calibration. With a checkpoint, the state is saved between solutions when that
/// is due, and an earlier state is resumed. Throws InputError when the problem is not sound or there are no loads or
/// moduli, NumericalError when a system cannot be solved or the tolerance cannot be met.
template <int dim>
[[nodiscard]] FilmResponses<dim> sample_film_responses(const FilmProblem<dim>& problem, std::span<const Load> loads,
                                                       std::span<const Moduli> training_set,
                                                       const SamplingOptions& options = {},
                                                       const ProgressObserver& observer = {},
                                                       Checkpoint* checkpoint = nullptr,
                                                       const std::optional<TargetCurve>& target = {});

}  // namespace breccia
