#pragma once

#include <array>
#include <cstdint>

#include "breccia/words.hpp"

namespace breccia {

/// The method by which the linear systems are solved.
enum class LinearMethod {
  automatic,  ///< direct up to a number of unknowns (LinearOptions), iterative above
  direct,     ///< sparse Cholesky factors (MUMPS) precondition conjugate gradients, which then need a step or two
  iterative   ///< conjugate gradients, preconditioned by substructures, or in 3 dimensions by fast transforms; MINRES
              ///< there for boxes with gaps narrower than a cell
};

template <>
inline constexpr auto words<LinearMethod> = std::to_array<Word<LinearMethod>>({{"automatic", LinearMethod::automatic},
                                                                               {"direct", LinearMethod::direct},
                                                                               {"iterative", LinearMethod::iterative}});

/// Settings of the linear solvers.
struct LinearOptions {
  LinearMethod method = LinearMethod::automatic;
  std::int64_t most_unknowns_direct = 250'000;
  /// The largest number of unknowns of the direct method in 3 dimensions, where the factors fill up.
  std::int64_t most_unknowns_direct_in_3d = 3'000;
  double tolerance = 1e-10;  ///< largest residual relative to the load, in the Euclidean norm [-]
  /// In 3 dimensions the iterative method ends when the error of the fluctuation, in the energy norm and relative to
  /// the fluctuation, is below this tolerance [-]; theory, section 18, gives the resulting error of a modulus.
  double energy_tolerance = 1e-6;
  int threads = 0;  ///< number of threads of each process for the iterative method; 0: all available threads

  /// Whether a system with so many unknowns is solved by the direct method.
  [[nodiscard]] bool is_direct(std::int64_t unknowns, int dimensions = 2) const noexcept {
    const auto most = dimensions > 2 ? most_unknowns_direct_in_3d : most_unknowns_direct;
    return method == LinearMethod::direct || (method == LinearMethod::automatic && unknowns <= most);
  }
};

/// Cost and accuracy of the solutions of linear systems.
struct LinearEffort {
  bool is_direct = true;
  std::int64_t unknowns = 0;
  int factorisations = 0;  ///< number of factorisations, or of set-ups of another preconditioner
  int solves = 0;
  int iterations = 0;           ///< iterations in all solves together
  int most_iterations = 0;      ///< largest number of iterations in one solve
  double largest_residual = 0;  ///< largest residual after a solve, relative to the load [-]
};

}  // namespace breccia
