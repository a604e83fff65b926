#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "breccia/films/film_problem.hpp"
#include "breccia/progress.hpp"
#include "breccia/quasistatic/quasistatic_problem.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/virtual_test/curve.hpp"
#include "breccia/virtual_test/quasistatic_options.hpp"
#include "breccia/virtual_test/test_fields.hpp"

#include "quasistatic/reduced/training_path.hpp"

namespace breccia {

class Checkpoint;

/// The body of a quasi-static test: cells or grains and films in 2 or 3 dimensions; the latter's boundary is that of
/// the test. In grains and films only the binder relaxes and varies.
using QuasistaticComposite = std::variant<Discretisation<2>, Discretisation<3>, FilmProblem<2>, FilmProblem<3>>;

/// A quasi-static virtual test.
struct QuasistaticTest {
  QuasistaticComposite composite;
  std::vector<Material> materials;  ///< materials by PhaseIndex
  Crystals crystals = {};           ///< phases of cells that are not isotropic, as those of a QuasistaticProblem
  /// The phases whose moduli vary in the reduced basis, the matrix first: all phases that relax, and possibly others.
  /// The stepping solver of cells does not use this list; that of films takes the first phase as the binder.
  std::vector<VaryingPhase> varying = {};
  /// Alternative materials of the varying phases, for which the reduced response must be valid, too; each list is in
  /// the order of these phases.
  std::vector<std::vector<Material>> variants = {};
  /// Carson moduli [Pa] of the varying phases and of their variants, in the order of the phases, over their whole
  /// relaxation, from stiff to soft. They are given for a matrix that is itself a composite, whose series is a fit in a
  /// limited range of times. If the list is empty, the moduli of the series are used. Used with SampledRange::matrix
  /// alone.
  std::vector<std::vector<Moduli>> relaxation = {};
  Volumetric volumetric = Volumetric::averaged;
  Boundary boundary = Boundary::displacement;
  std::vector<Load> loads;
  TimeWindow times;                      ///< times of the curves [s]
  int points_per_decade = 20;            ///< samples per decade of the curves
  std::vector<double> field_times = {};  ///< rising times at which fields of the first load are wanted [s]
  QuasistaticOptions options = {};
};

/// The response to one load.
struct QuasistaticResponse {
  Load load = Load::shear;
  Curve modulus;       ///< relaxation modulus at logarithmic times; under a traction boundary by interconversion
  Creep compliance;    ///< creep compliance at the same times, under a traction boundary alone
  PronySeries series;  ///< relaxation modulus; exact with the reduced solver, a fit with the stepping solver
  /// Largest estimated relative error [-]: of the reduced basis over the training set, or of the time steps.
  double error_estimate = 0.0;
  std::optional<double> fit_error = {};  ///< largest relative deviation of the series from the steps [-]
  std::optional<ReducedResponse> reduced = {};
};

/// The result of a quasi-static test.
struct QuasistaticTestResult {
  std::vector<QuasistaticResponse> responses;  ///< responses by load
  TestFields fields;                           ///< fields under the first load
  LinearEffort effort;
  double seconds = 0.0;  ///< wall time [s]
};

/// Runs a test. With a checkpoint, the state is saved when that is due, and an earlier state is resumed, with results
/// that are bitwise identical to those of one run; a finished test returns its result without the fields. Throws
/// InputError for an incomplete test or field times outside its times, NumericalError when a linear system cannot be
/// solved or the basis leaves an error above a tenth.
QuasistaticTestResult run_quasistatic_test(const QuasistaticTest& test, const ProgressObserver& observer = {},
                                           Checkpoint* checkpoint = nullptr);

}  // namespace breccia
