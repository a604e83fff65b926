#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/study/study.hpp"

namespace breccia {

/// Memory that a choice may take [B].
inline constexpr double most_bytes_of_choice = 8e9;

/// The accuracy that is wanted of a study, and what it may cost.
struct AccuracyGoal {
  double error = 0.03;     ///< largest whole error of the moduli of the last stage [-]
  double seconds = 600.0;  ///< processor time of all tests on a core like that of the measured costs [s]
};

/// The box and the grid that were chosen for a stage, and what is to be expected of them.
struct BoxChoice {
  std::string stage;
  int particles = 0;                  ///< number of particles of a chosen box; 0 where the box was given
  std::optional<double> grid = {};    ///< expected error of the grid [-]; nothing where no rule holds
  std::optional<double> sample = {};  ///< expected error of the sample [-]; nothing where no rule holds
  double seconds = 0.0;               ///< expected processor time of the tests [s]
  double goal = 0.0;                  ///< error that was wanted of the stage [-]
  double budget = 0.0;                ///< processor time that its tests may take [s]
  /// Processor time and memory of the cheapest box and grid that would reach the goal [s, B]; nothing where none does.
  std::optional<double> seconds_of_goal = {}, bytes_of_goal = {};

  /// The expected error [-]; nothing where a part of it is not known.
  [[nodiscard]] std::optional<double> error() const;
  /// Whether the expected error is known and no larger than what was wanted.
  [[nodiscard]] bool reaches_goal() const;
};

/// Whether a stage lacks its box or its grid.
bool needs_choice(const Stage& stage);

/// Chooses the box of each stage whose side is 0, and the grid of each stage with 0 cells: those that reach the goal in
/// the least time or, if this is more than the goal allows, those with the least error within that time and 8 GB. The
/// stages of a chain share the goal, the squares of their errors in equal parts, and all stages share the time. For it
/// each of these stages is packed, a chosen one with few particles. Deterministic, and the same on all machines. A
/// stage for whose grid no rule holds that is within the time gets two grids, which measure its error. Throws as
/// side_of_particles() and make_microstructure().
std::vector<BoxChoice> choose_boxes(Study& study, const AccuracyGoal& goal);

}  // namespace breccia
