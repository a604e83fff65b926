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

/// The training set of a reduced basis: joint moduli [Pa] of the varying phases, one point for each real Laplace
/// variable, from stiff to soft (theory, section 10). All other phases keep the moduli of their materials. An elastic
/// phase may be among the varying ones, with the same moduli at every point; the response then has separate parts for
/// it.
struct TrainingPath {
  std::vector<VaryingPhase> phases;
  std::vector<std::vector<Moduli>> points;  ///< points with the moduli of the phases, in the order of these
  /// A curve in time that must meet the same tolerance, if one is known.
  std::optional<TargetCurve> target = {};
};

/// The training set in which the moduli [Pa] of the matrix alone vary.
TrainingPath matrix_path(PhaseIndex matrix, std::span<const Moduli> moduli);

}  // namespace breccia
