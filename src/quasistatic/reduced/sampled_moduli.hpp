#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// Smallest and largest moduli of a phase [Pa].
struct ModuliRange {
  Moduli least;
  Moduli most;
};

/// Whether a reduced response can be used with another material of one of its phases over a time window.
struct PhaseCoverage {
  std::string phase;
  ModuliRange sampled = {};      ///< moduli of the phase for which the response can be used
  ModuliRange shown = {};        ///< Carson moduli of the material at s = 1/t over the window
  bool is_shear_covered = true;  ///< does the shear modulus stay within the sampled range?
  bool is_bulk_covered = true;   ///< does the bulk modulus?

  [[nodiscard]] bool is_whole() const noexcept { return is_shear_covered && is_bulk_covered; }
};

/// Whether a reduced response can be used with other materials over a time window.
struct Coverage {
  std::vector<PhaseCoverage> phases;     ///< in the order of ReducedResponse::phases()
  std::optional<TimeWindow> times = {};  ///< the longest part of the window in which all moduli are covered [s]

  [[nodiscard]] bool is_whole() const { return std::ranges::all_of(phases, &PhaseCoverage::is_whole); }
};

/// Compares the moduli that the materials of the varying phases show over a window with those of the snapshots of a
/// response. A response can be used between the moduli of its snapshots, and a little beyond them. With several phases
/// the snapshots lie on one path: whether the response can be used beside it, where each modulus is covered but not
/// their combination, follows from largest_error(). Throws InputError when the materials are not as many as the phases.
Coverage coverage(const ReducedResponse& response, std::span<const Material> of_phases, const TimeWindow& window);

/// Largest error estimate of a response for the moduli that its phases show over a window, relative [-].
double largest_error(const ReducedResponse& response, std::span<const Material> of_phases, const TimeWindow& window);

}  // namespace breccia
