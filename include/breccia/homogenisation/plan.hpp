#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "breccia/error.hpp"
#include "breccia/homogenisation/filler_statistics.hpp"
#include "breccia/progress.hpp"
#include "breccia/study/study.hpp"
#include "breccia/study/sweep.hpp"
#include "breccia/virtual_test/time_domain.hpp"

namespace breccia {

/// The expected size, time and memory of a virtual test: of a quasi-static test under all loads, or of a dynamic test
/// under one load.
struct TestPlan {
  Method method = Method::quasistatic;
  Boundary boundary = Boundary::displacement;
  std::optional<Load> load = {};  ///< load of a dynamic test
  std::string size = {};          ///< size of the model: "100 x 100 cells", "25 grains and films"
  double unknowns = 0.0;          ///< number of unknowns; of a dynamic test, of material points
  double seconds = 0.0;  ///< time on one core like that of the measured costs; of a dynamic test, on this machine [s]
  double bytes = 0.0;    ///< memory of the program in this test [B]
  std::vector<TimeDomain> domains = {};  ///< time domains of a dynamic test
  double speed = 0.0;                    ///< speed of a dynamic test, measured on this machine [points x steps/s]
};

/// An empirical rule for the error of a grid: with c cells along a characteristic length, the error is at most
/// error_of_one c^-order.
struct ErrorRule {
  double error_of_one;  ///< [-]
  double order;         ///< [-]
  double least_cells;   ///< number of cells below which the error may be of any size
  /// Number of cells up to which finer grids were measured: beyond, the error is that of this number.
  double most_cells = std::numeric_limits<double>::infinity();

  /// The largest relative error [-] to be expected of the moduli; nothing where it may be of any size.
  [[nodiscard]] std::optional<double> error_with(double cells) const;
  /// The number of cells [-] from which on the expected error is no larger than this; infinite where none is known.
  [[nodiscard]] double cells_for(double error) const;
};

/// The finest grid of a stage and the error to be expected of it.
struct GridPlan {
  double cell_size = 0.0;              ///< [m]
  double side = 0.0;                   ///< side of the box [m]
  double length = 0.0;                 ///< characteristic length, on whose number of cells the error depends [m]
  std::string_view place = {};         ///< location of this length: "in the narrowest gap"
  std::optional<ErrorRule> rule = {};  ///< rule for the error; nothing where no rule is known
  /// The error of interfaces in cells of unit length [1/m]: the error by the rule is no less than this times the size
  /// of a cell.
  double interfaces = 0.0;
  std::string_view caveat = {};        ///< range of the rule: "that is extrapolated from 30 to 50 % of spheres"
  std::string_view without_rule = {};  ///< content for which there is no rule: "ellipsoids"

  /// Number of cells along the characteristic length [-].
  [[nodiscard]] double cells() const { return length / cell_size; }
  /// The largest relative error [-] to be expected; nothing where it is not known, or may be of any size.
  [[nodiscard]] std::optional<double> error() const;
  /// Cells per side of a grid whose expected error is no larger than this [-]; nothing where none is known.
  [[nodiscard]] std::optional<double> cells_for(double error) const;
};

/// The plan of a stage. Its box is packed in order to make the plan.
struct StagePlan {
  std::string stage = {};
  std::vector<TestPlan> tests = {};
  /// Plan of the grid; nothing for films, and where the error of the grid cannot be estimated.
  std::optional<GridPlan> grid = {};
  /// The error of the box in place of all of its make to be expected by a rule [-]; nothing where no rule holds.
  std::optional<double> sample_error = {};
  std::vector<FillerStatistics> fillers = {};  ///< statistics of the fillers in the packed box
  std::vector<std::string> warnings = {};      ///< warnings about the stage as it is packed (warnings_on)
  /// What is known beforehand of its quasi-static tests: a range of moduli that takes far less time, and that rounding
  /// may keep the tolerance from being met.
  std::vector<std::string> remarks = {};
};

/// The plan of a study: the plans of its stages.
struct StudyPlan {
  std::vector<StagePlan> stages = {};

  /// Time of all tests, one after the other [s].
  [[nodiscard]] double seconds() const;
  /// Memory of the largest test [B].
  [[nodiscard]] double bytes() const;
};

/// The plans of all tasks of a sweep. Tasks that differ by seeds alone share the plan of the first of them that packs.
struct SweepPlan {
  /// The plan of one or several tasks, or the reason why there is none, such as a box that cannot be packed.
  struct Part {
    std::vector<std::size_t> tasks = {};  ///< numbers of the tasks that share the plan, rising
    StudyPlan plan = {};
    std::string failure = {};
  };
  std::vector<Part> parts = {};  ///< parts, in the order of their first tasks

  /// Time of all tasks, one after the other [s].
  [[nodiscard]] double seconds() const;
  /// The part that takes the most memory, if there is at least one part.
  [[nodiscard]] const Part& largest() const;
};

/// Plans a study: packs the boxes of its stages, and runs a trial of a fraction of a second for dynamic tests. No
/// quasi-static test is computed. Throws the errors of require_sound(), make_microstructure() and plan_dynamic_test().
/// The observer is told how far a packing is.
StudyPlan plan_of(const Study& study, const ProgressObserver& follow = {});
SweepPlan plan_of(const Sweep& sweep, const ProgressObserver& follow = {});

/// The memory [B] of all processes together for the largest test of spheres with flow through gaps, which several
/// processes solve by sparse factors; nothing for a study without such a test.
std::optional<double> memory_of_factors(const Study& study, const StudyPlan& plan);

/// The least memory [B] that each of several processes needs for a test that takes `bytes` on a single process: its
/// part of the data, and the program.
double memory_of_process(double bytes, int processes);

/// Error: a study will take more memory than there is.
class LackingMemory : public InputError {
 public:
  using InputError::InputError;
};

/// Throws LackingMemory where a stage needs more than the available memory [B], with a line for every stage and method
/// and the number of cells, or of grains with films, that would fit. It assumes a single process. Nothing is packed;
/// lattices and lists of particles are set up, whose errors are thrown (make_microstructure).
void require_memory(const Study& study, double available);
/// Overload for these tasks of a sweep. Where several tasks have equal lines, the message names the first of these
/// tasks and counts the others.
void require_memory(const Sweep& sweep, const std::vector<std::size_t>& tasks, double available);
/// Overload for all tasks of a sweep.
void require_memory(const Sweep& sweep, double available);

}  // namespace breccia
