#pragma once

#include <optional>

#include "breccia/quasistatic/reduced_response.hpp"
#include "breccia/viscoelasticity/material.hpp"
#include "breccia/viscoelasticity/reduction.hpp"

namespace breccia {

/// Smallest and largest moduli of a matrix [Pa].
struct ModuliRange {
  Moduli least;
  Moduli most;
};

/// Whether a reduced response can be used with another matrix over a time window.
struct Coverage {
  ModuliRange sampled = {};              ///< moduli of the matrix for which the response can be used
  ModuliRange shown = {};                ///< Carson moduli of the matrix at s = 1/t over the window
  bool is_shear_covered = true;          ///< does the shear modulus stay within the sampled range?
  bool is_bulk_covered = true;           ///< does the bulk modulus?
  std::optional<TimeWindow> times = {};  ///< the longest part of the window in which both do [s]

  [[nodiscard]] bool is_whole() const noexcept { return is_shear_covered && is_bulk_covered; }
};

/// Compares the moduli that a matrix shows over a window with those of the snapshots of a response. A response can be
/// used between the moduli of its snapshots, and a little beyond them.
Coverage coverage(const ReducedResponse& response, const Material& matrix, const TimeWindow& window);

/// Largest error estimate of a response for the moduli that a matrix shows over a window, relative [-].
double largest_error(const ReducedResponse& response, const Material& matrix, const TimeWindow& window);

}  // namespace breccia
