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
  bool is_shear_covered = true;  ///< whether the shear modulus stays within the sampled range
  bool is_bulk_covered = true;   ///< whether the bulk modulus stays within the sampled range

  [[nodiscard]] bool is_whole() const noexcept { return is_shear_covered && is_bulk_covered; }
};

/// Whether a reduced response can be used with other materials over a time window.
struct Coverage {
  std::vector<PhaseCoverage> phases;     ///< coverage of the phases, in the order of ReducedResponse::phases()
  std::optional<TimeWindow> times = {};  ///< the longest part of the window in which all moduli are covered [s]

  [[nodiscard]] bool is_whole() const { return std::ranges::all_of(phases, &PhaseCoverage::is_whole); }
};

/// Compares the Carson moduli of the materials of the varying phases over a window with the moduli of the snapshots of
/// a response. A response can be used between the moduli of its snapshots, and a little beyond them. With several
/// phases the snapshots lie on one path. Whether the response can be used off that path, where each modulus is covered
/// but not their combination, follows from largest_error(). Throws InputError when the numbers of materials and of
/// varying phases differ.
Coverage coverage(const ReducedResponse& response, std::span<const Material> of_phases, const TimeWindow& window);

/// Largest relative error estimate [-] of a response for the moduli of its phases over a window.
double largest_error(const ReducedResponse& response, std::span<const Material> of_phases, const TimeWindow& window);

}  // namespace breccia
