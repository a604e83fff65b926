#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "breccia/discretisation/moduli.hpp"
#include "breccia/discretisation/phase.hpp"

#include "quasistatic/reduced/target_curve.hpp"

namespace breccia {

/// A phase whose moduli vary in a reduced basis.
struct VaryingPhase {
  PhaseIndex index = no_phase;
  std::string name;
};

/// The training set of a reduced basis: moduli [Pa] that the phases which vary take together, one point for each real
/// Laplace variable, from stiff to soft (theory, section 10). All other phases keep the moduli of their materials. A
/// phase that is elastic may be among those that vary, with the same moduli at every point: the response then has parts
/// of its own for it.
struct TrainingPath {
  std::vector<VaryingPhase> phases;
  std::vector<std::vector<Moduli>> points;  ///< each with the moduli of the phases, in their order
  /// The curve that is to be as accurate in time, if one is known.
  std::optional<TargetCurve> target = {};
};

/// The training set in which the moduli [Pa] of the matrix alone vary.
TrainingPath matrix_path(PhaseIndex matrix, std::span<const Moduli> moduli);

}  // namespace breccia
