#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/deck/sweep.hpp"
#include "breccia/error.hpp"
#include "breccia/homogenisation/filler_statistics.hpp"
#include "breccia/study/study.hpp"
#include "breccia/virtual_test/time_domain.hpp"

namespace breccia {

/// What a virtual test is expected to take: a quasi-static test of all loads, or a dynamic test of one load.
struct TestPlan {
  Method method = Method::quasistatic;
  Boundary boundary = Boundary::displacement;
  std::optional<Load> load = {};  ///< of a dynamic test
  std::string size = {};          ///< what it is computed with: "100 x 100 cells", "25 grains and films"
  double unknowns = 0.0;          ///< of a quasi-static test; of a dynamic one its material points
  double seconds = 0.0;           ///< on one core as that of the measured costs; of a dynamic test on this machine
  double bytes = 0.0;             ///< memory of the program in this test [B]
  std::vector<TimeDomain> domains = {};  ///< of a dynamic test
  double speed = 0.0;                    ///< of a dynamic test, measured on this machine [points x steps/s]
};

/// An empirical rule for the error of a grid: with c cells along some length it is at most error_of_one c^-order.
struct ErrorRule {
  double error_of_one;  ///< [-]
  double order;         ///< [-]
  double least_cells;   ///< below them the error may be of any size

  /// The largest relative error [-] to be expected of the moduli; nothing where it may be of any size.
  [[nodiscard]] std::optional<double> error_with(double cells) const;
  /// The cells from which on no larger error than this is to be expected [-].
  [[nodiscard]] double cells_for(double error) const;
};

/// What is expected of the finest grid of a stage.
struct GridPlan {
  double cell_size = 0.0;              ///< [m]
  double side = 0.0;                   ///< of the box [m]
  double length = 0.0;                 ///< on whose cells the error depends [m]
  std::string_view place = {};         ///< of these cells: "in the narrowest gap"
  std::optional<ErrorRule> rule = {};  ///< nothing where none is known
  std::string_view without_rule = {};  ///< what has no rule: "ellipsoids"

  /// Cells along that length [-].
  [[nodiscard]] double cells() const { return length / cell_size; }
  /// The largest relative error [-] to be expected; nothing where it is not known, or may be of any size.
  [[nodiscard]] std::optional<double> error() const;
  /// Cells per side of a grid of which no larger error than this [-] is to be expected; nothing without a rule.
  [[nodiscard]] std::optional<double> cells_for(double error) const;
};

/// The plan of a stage, whose box is packed for it.
struct StagePlan {
  std::string stage = {};
  std::vector<TestPlan> tests = {};
  std::optional<GridPlan> grid = {};  ///< nothing for films, and where nothing determines the error of the grid
  std::vector<FillerStatistics> fillers = {};  ///< of the packed box
  std::vector<std::string> warnings = {};      ///< on the stage as it is packed (warnings_on)
};

struct StudyPlan {
  std::vector<StagePlan> stages = {};

  /// Time of all tests, one after the other [s].
  [[nodiscard]] double seconds() const;
  /// Memory of the largest test [B].
  [[nodiscard]] double bytes() const;
};

/// The plans of all tasks of a sweep. Tasks that differ by seeds alone share the plan of the first of them that packs.
struct SweepPlan {
  /// A plan, or why there is none: a box that cannot be packed.
  struct Part {
    std::vector<std::size_t> tasks = {};  ///< the tasks that share it, rising
    StudyPlan plan = {};
    std::string failure = {};
  };
  std::vector<Part> parts = {};  ///< in the order of their first tasks

  /// Time of all tasks, one after the other [s].
  [[nodiscard]] double seconds() const;
  /// The part that takes most memory, of at least one part.
  [[nodiscard]] const Part& largest() const;
};

/// Plans a study: packs the boxes of its stages, and runs a trial of a fraction of a second for dynamic tests. No
/// quasi-static test is computed. Throws the errors of require_sound(), make_microstructure() and plan_dynamic_test().
StudyPlan plan_of(const Study& study);
SweepPlan plan_of(const Sweep& sweep);

/// The least memory [B] of each of several processes that have a test which takes so much on one: its part, and the
/// program.
double memory_of_process(double bytes, int processes);

/// A study will take more memory than there is.
class LackingMemory : public InputError {
 public:
  using InputError::InputError;
};

/// Throws LackingMemory where a stage needs more than the available memory [B], with a line for every stage and method
/// and the number of cells, or of grains with films, that would fit. It assumes a single process. Nothing is packed.
void require_memory(const Study& study, double available);
/// Throws the same for these tasks of a sweep; for equal lines it names the first task and counts the others.
void require_memory(const Sweep& sweep, const std::vector<std::size_t>& tasks, double available);
/// Throws the same for all tasks of a sweep.
void require_memory(const Sweep& sweep, double available);

}  // namespace breccia
