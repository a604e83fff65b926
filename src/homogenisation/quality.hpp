#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "breccia/homogenisation/plan.hpp"
#include "breccia/homogenisation/study_result.hpp"
#include "breccia/study/study.hpp"

#include "homogenisation/anisotropy.hpp"
#include "homogenisation/box_bounds.hpp"
#include "homogenisation/factor_of_space.hpp"

namespace breccia {

/// Measures of the accuracy of a stage's results that follow from the run itself.
struct StageQuality {
  int dimensions = 2;
  Abscissa abscissa = Abscissa::time;  ///< in which times are told
  std::string matrix_stage;            ///< the earlier stage that is the matrix; empty if the matrix is a material
  std::size_t particles = 0;
  double fraction = 0.0;                 ///< area fraction of the particles [-]
  std::optional<double> fraction_asked;  ///< area fraction in the deck [-]; only for a packing that draws its particles
  /// The narrowest gap in cells of the finest grid; infinite without a gap.
  double gap_cells = std::numeric_limits<double>::infinity();
  bool has_flow = false;                     ///< whether the matrix flows through the gaps
  std::optional<double> coating_cells = {};  ///< the thinnest coating in cells of the finest grid; nothing without one
  FilmOptions films = {};                    ///< elements of grains and films
  std::optional<Debonding> debonding = {};   ///< of films that are debonded
  std::vector<int> grids;                    ///< cells per side, rising; empty where films are computed without cells
  bool is_random = false;                    ///< whether the packing depends on a seed
  /// The share of the sides that lies in filler [-], 0 and more for a window in a larger body under displacement or
  /// traction; nothing for another box.
  std::optional<double> filler_on_sides = {};
  bool has_films_along_walls = false;          ///< whether only the displacement boundary makes sense
  bool is_periodic = false;                    ///< whether a periodic test is finished, which gives no bound
  std::optional<double> grid_share;            ///< largest half band over the modulus [-]; nothing for a single grid
  std::optional<double> grid_share_of_others;  ///< the same of the boundaries beside the periodic one
  /// The error of a single grid to be expected by a rule; nothing for several grids, and for films.
  std::optional<GridPlan> one_grid = {};
  ErrorRules rules = {};
  std::optional<double> error_asked = {};  ///< largest whole error that is wanted (tests.accuracy) [-]
  /// The largest whole error, and the largest parts of the sample and of the matrix in it [-]: as LargestErrors.
  std::optional<double> error = {}, sample_error = {}, matrix_error = {};
  std::vector<LoadQuality> loads;             ///< bounds of the finished tests
  std::optional<Anisotropy> anisotropy = {};  ///< of the shears of which the result is the mean
  /// The largest ratio of the moduli of spheres to these, of random particles in two dimensions.
  std::optional<FactorOfSpace> space = {};

  /// The narrowest gap in cells of one of the grids, given by its cells per side.
  [[nodiscard]] double gap_cells_on(int grid) const { return gap_cells * grid / grids.back(); }
};

/// The quality of a stage's results, from the tests that are finished so far.
StageQuality quality_of(const Study& study, const Stage& stage, const StageResult& result);

/// Cells per side of two grids that measure the error of a single one: itself and one of half the cells or, where these
/// are few, of twice the cells. Nothing for several grids, for films, and for flow between spheres, whose error does
/// not show in the change from one grid to another.
std::optional<std::array<int, 2>> grids_that_measure(const StageQuality& quality);

/// The rule for the error of a grid, in words: "by a rule of packings of 52 and 55 %", "no rule for
/// ellipsoids", "too few cells for a rule".
std::string words_on_rule(const GridPlan& grid);

/// The quality in words: "bounds 18 % apart at 1 ms, 34 % at 100 s; grid: one grid, error up to about 4 % by a
/// rule (cells = [75, 150] measures it); narrowest gap: 3 cells; packing: one seed, scatter unknown". It begins with
/// the whole error where that is known, "error up to 5.2 %". For several loads or methods it reports the bounds that
/// cross each other by most, or else the first ones, and names them. Empty for a box without particles.
std::string summary_of(const StageQuality& quality);

/// The quality as a result of the stage has it.
StageAccuracy accuracy_of(const StageQuality& quality);

/// The accuracy of a stage that was answered from its reduced responses under these rules.
StageAccuracy accuracy_of_answer(const StageResult& answer, const ErrorRules& rules);

/// A warning, without the name of the stage, for each load and method whose modulus under displacement is below that
/// under traction beyond the error of the grids, with the likely causes.
std::vector<std::string> warnings_on_bounds(const StageQuality& quality);

/// Warnings about too few particles, unless an error is asked for that a rule judges, and about a fraction that differs
/// from the one in the deck.
std::vector<std::string> warnings_on_packing(const Study& study, const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia
