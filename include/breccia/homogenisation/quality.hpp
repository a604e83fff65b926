#pragma once

#include <optional>
#include <string>
#include <vector>

#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// What a box says of a modulus at one time.
struct BoundsAtTime {
  double time = 0.0;                     ///< [s]
  std::optional<double> upper, lower;    ///< the bounds [Pa]; nothing where one was not tested
  std::optional<double> grid_half_band;  ///< of the extrapolation to vanishing cells, the larger one of both [Pa]

  /// upper / lower - 1 [-]; nothing without both of them.
  [[nodiscard]] std::optional<double> distance() const;
  /// The half band over the modulus that it belongs to [-]; nothing where there is a single grid.
  [[nodiscard]] std::optional<double> grid_share() const;
};

/// The bounds under one load and by one method, of several grids those of the extrapolation.
struct LoadQuality {
  Load load = Load::shear;
  Method method = Method::quasistatic;
  std::vector<BoundsAtTime> times;  ///< at both ends of the curves and at each decade between them
};

/// How good the results of a stage are, as far as the run itself can tell.
struct StageQuality {
  std::string matrix_stage;  ///< the stage that made its matrix; empty where that is a material
  std::size_t particles = 0;
  double fraction = 0.0;                 ///< reached: share of the box [-]
  std::optional<double> fraction_asked;  ///< [-]; only of a packing that draws its particles
  double gap_cells = 0.0;                ///< the narrowest gap in cells of the finest grid; infinite without a gap
  std::vector<int> grids;                ///< cells per side, rising
  bool is_random = false;                ///< would another seed make another box?
  std::vector<LoadQuality> loads;        ///< of the tests that are done
};

/// The bounds of all loads and methods that were tested.
std::vector<LoadQuality> bounds_of_tests(const StageResult& result);

/// How good the results of a stage are; of a stage that is being tested, those it has so far.
StageQuality quality_of(const Stage& stage, const StageResult& result);

/// It in words, for people: "bounds 18 % apart at 1 ms, 34 % at 100 s; grid: one grid, error unknown (give cells =
/// [150, 300]); narrowest gap: 3 cells; packing: one seed, scatter unknown (--seeds 3)". Empty for a box without
/// particles.
std::string summary_of(const StageQuality& quality);

/// Warnings of too few particles, and of a fraction that is not the one asked for.
std::vector<std::string> warnings_on_packing(const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia
