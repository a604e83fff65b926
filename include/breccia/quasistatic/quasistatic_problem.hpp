#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "breccia/checkpoint/state.hpp"
#include "breccia/discretisation/discretisation.hpp"
#include "breccia/discretisation/load.hpp"
#include "breccia/discretisation/volumetric.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/words.hpp"

namespace breccia {

/// How the linear systems are solved.
enum class LinearMethod {
  automatic,  ///< direct up to LinearOptions::most_unknowns_direct, iterative above
  direct,     ///< sparse Cholesky factors (MUMPS) precondition conjugate gradients, which then need a step or two
  iterative   ///< conjugate gradients on substructures, or with algebraic multigrid (GAMG) on several processes
};

template <>
inline constexpr auto words<LinearMethod> = std::to_array<Word<LinearMethod>>({{"automatic", LinearMethod::automatic},
                                                                               {"direct", LinearMethod::direct},
                                                                               {"iterative", LinearMethod::iterative}});

struct LinearOptions {
  LinearMethod method = LinearMethod::automatic;
  std::int64_t most_unknowns_direct = 250'000;
  /// The same on several processes, where the iterative method is a slower one.
  std::int64_t most_unknowns_direct_on_several = 3'000'000;
  double tolerance = 1e-10;  ///< residual over load, in the Euclidean norm [-]
  int threads = 0;           ///< of each process, for substructures; 0: all

  [[nodiscard]] bool is_direct(std::int64_t unknowns, int processes) const noexcept {
    const auto most = processes > 1 ? most_unknowns_direct_on_several : most_unknowns_direct;
    return method == LinearMethod::direct || (method == LinearMethod::automatic && unknowns <= most);
  }
};

/// What solving the linear systems took.
struct LinearEffort {
  bool is_direct = true;
  std::int64_t unknowns = 0;
  int factorisations = 0;  ///< or multigrid set-ups
  int solves = 0;
  int iterations = 0;           ///< of conjugate gradients, in all
  int most_iterations = 0;      ///< of one solve
  double largest_residual = 0;  ///< over load, after a solve [-]
};

/// Leaves it in a group of a state, and takes it up. The latter throws FileError where that is none.
void save(StateWriter& state, const std::string& group, const LinearEffort& effort);
LinearEffort read_effort(const StateReader& state, const std::string& group);

/// A composite without inertia: what both quasi-static solvers solve. Points must all have a material.
struct QuasistaticProblem {
  Discretisation discretisation;
  std::vector<Material> materials;  ///< by MaterialIndex
  Volumetric volumetric = Volumetric::averaged;
  Boundary boundary = Boundary::displacement;
  LinearOptions linear = {};
};

}  // namespace breccia
