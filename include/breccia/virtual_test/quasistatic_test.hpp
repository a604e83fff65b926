#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "breccia/quasistatic/quasistatic_problem.hpp"
#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/quasistatic/sampling.hpp"
#include "breccia/virtual_test/curve.hpp"
#include "breccia/words.hpp"

namespace breccia {

class Checkpoint;

/// How the quasi-static method goes through time.
enum class Solver {
  reduced,  ///< a few elastic solutions span all times: exact poles
  stepping  ///< step by step in log time: the reference, and the way where filler relaxes
};

template <>
inline constexpr auto words<Solver> = std::to_array<Word<Solver>>({{"reduced", Solver::reduced},
                                                                   {"stepping", Solver::stepping}});

/// Over which moduli of the matrix a reduced response is sampled.
enum class SampledRange {
  matrix,  ///< all that the matrix shows from unrelaxed to relaxed: every temperature can be answered
  times    ///< those that count at the times wanted
};

template <>
inline constexpr auto words<SampledRange> = std::to_array<Word<SampledRange>>({{"matrix", SampledRange::matrix},
                                                                               {"times", SampledRange::times}});

/// Settings of the quasi-static method.
struct QuasistaticOptions {
  Solver solver = Solver::reduced;
  SampledRange range = SampledRange::matrix;  ///< of the reduced solver
  Volumetric volumetric = Volumetric::averaged;
  SamplingOptions sampling = {};  ///< of the reduced solver
  int steps_per_decade = 20;      ///< of the stepping solver
  LinearOptions linear = {};
};

/// What a quasi-static test is made on. The matrix is material 0.
struct QuasistaticTest {
  Discretisation<2> discretisation;
  std::vector<Material> materials;  ///< by PhaseIndex
  /// Moduli [Pa] that the matrix shows over the whole of its relaxation, from stiff to soft, where its series does not
  /// tell them: that of a composite is a fit to some times. Empty: those of its series. For SampledRange::matrix alone.
  std::vector<Moduli> matrix_moduli = {};
  Boundary boundary = Boundary::displacement;
  std::vector<Load> loads;
  TimeWindow times;                      ///< wanted [s]
  int points_per_decade = 20;            ///< of the curves
  std::vector<double> field_times = {};  ///< at which the fields of the first load are wanted, rising [s]
  QuasistaticOptions options = {};
};

/// The answer to one load.
struct QuasistaticResponse {
  Load load = Load::shear;
  Curve modulus;       ///< relaxation modulus at logarithmic times; from creep by interconversion
  Creep compliance;    ///< creep compliance at the same times, of a traction boundary alone
  PronySeries series;  ///< exact by the reduced solver; a fit by the stepping one
  /// Largest, relative, by the method in time; of the reduced solver over all moduli of the matrix sampled [-].
  double error_estimate = 0.0;
  std::optional<double> fit_error = {};  ///< largest relative deviation of the series from the steps [-]
  std::optional<ReducedResponse> reduced = {};
};

struct QuasistaticTestResult {
  std::vector<QuasistaticResponse> responses;  ///< by load
  std::vector<TimedFields<2>> fields;          ///< of the first load; on the first process, on the others zero
  LinearEffort effort;
  double seconds = 0.0;  ///< wall time
};

/// Told what is going on, and the share of the test that is done, 0 to 1. What it throws ends the test.
using QuasistaticObserver = std::function<void(const std::string& details, double share)>;

/// With a checkpoint the test leaves its state there when that is due, and goes on from what is there: the same bits as
/// in one go; of a test that is finished the result without its fields.
/// Throws InputError for an incomplete test or fields outside its times, NumericalError when a linear system or the
/// tolerance defeats it.
QuasistaticTestResult run_quasistatic_test(const QuasistaticTest& test, const QuasistaticObserver& observer = {},
                                           Checkpoint* checkpoint = nullptr);

}  // namespace breccia
