#pragma once

#include <array>

#include "breccia/quasistatic/linear_options.hpp"
#include "breccia/quasistatic/sampling_options.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// The time integration of the quasi-static method.
enum class Solver {
  reduced,  ///< reduced basis of a few elastic solutions, with exact poles in time
  stepping  ///< log-time stepping: the reference
};

template <>
inline constexpr auto words<Solver> = std::to_array<Word<Solver>>({{"reduced", Solver::reduced},
                                                                   {"stepping", Solver::stepping}});

/// Training set of a reduced response: moduli of the matrix and of the other phases that vary.
enum class SampledRange {
  matrix,  ///< the whole relaxation of these phases: with the matrix alone it is valid at every temperature
  times    ///< the moduli that matter at the times of the test
};

template <>
inline constexpr auto words<SampledRange> = std::to_array<Word<SampledRange>>({{"matrix", SampledRange::matrix},
                                                                               {"times", SampledRange::times}});

/// Settings of the quasi-static method.
struct QuasistaticOptions {
  Solver solver = Solver::reduced;
  SampledRange range = SampledRange::matrix;  ///< range of the training set of the reduced solver
  SamplingOptions sampling = {};              ///< selection of the snapshots of the reduced solver
  int steps_per_decade = 20;                  ///< time steps of the stepping solver
  LinearOptions linear = {};
};

}  // namespace breccia
