#include "campaign/sweep.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "breccia/error.hpp"
#include "breccia/homogenisation/plan.hpp"

#include "campaign/result_transaction.hpp"
#include "campaign/shared_stages.hpp"
#include "campaign/sweep_directory.hpp"
#include "campaign/sweep_temperatures.hpp"
#include "io/text_file.hpp"
#include "page/sweep_report.hpp"
#include "parallel/available_memory.hpp"
#include "parallel/common_failure.hpp"
#include "parallel/session.hpp"
#include "results/result_files.hpp"
#include "results/study_record.hpp"
#include "results/sweep_plot.hpp"
#include "results/sweep_tables.hpp"

namespace breccia {

namespace {

/// Runs the tasks of a sweep and writes its tables after each of them.
class SweepRun {
 public:
  SweepRun(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options,
           const RunObserver& observer)
      : sweep_(sweep),
        directory_(directory),
        options_(options),
        observer_(observer),
        shared_(sweep),
        result_(sweep.tasks.size()) {}

  SweepResult run() {
    const SweepDirectory held(sweep_, directory_, options_);
    options_of_ = held.options_of_tasks();
    find_complete_tasks(held.complete_runs());
    if (!options_.solve.ignore_memory && parallel::is_alone()) require_memory_of_tasks();
    prepare_directory();
    if (options_.resume) write();
    // Written before the first task, so that a resumed sweep knows which results it may replace.
    if (options_.overwrite) by_first_group([&] { write_record(); });
    for (std::size_t task = 0; task < sweep_.tasks.size(); ++task) {
      if (!is_ours(task)) continue;
      if (options_.resume && result_[task].state == TaskState::done) {
        observer_.tell(TaskSkipped{sweep_, task});
        continue;
      }
      observer_.tell(TaskBegun{sweep_, task});
      run(task);
      write();
    }
    if (parallel::groups() > 1) {
      exchange();
      write();
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::filesystem::path directory_of(std::size_t task) const {
    return sweep_.tasks[task].directory_in(directory_);
  }

  [[nodiscard]] std::vector<TaskCurve> stored_curves(std::size_t task) const {
    return read_task_curves(directory_of(task), sweep_.tasks[task].study.tests.abscissa());
  }

  /// Runs an action on the first process of the first group, which writes the tables of all groups; if it fails there,
  /// it fails on all processes of that group.
  template <class Action>
  static void by_first_group(const Action& action) {
    if (parallel::group() == 0) parallel::done_by_first(action);
  }

  void prepare_directory() const {
    by_first_group([&] {
      make_directory(directory_);
      remove_partial_sweep_files(directory_);
    });
  }

  /// Keeps the results of the tasks that were complete before any task runs. Without `resume` they run again; until
  /// then the tables have their earlier results.
  void find_complete_tasks(const std::vector<CompleteRun>& runs) {
    for (std::size_t task = 0; task < runs.size(); ++task) {
      const auto& [seconds, note] = runs[task];
      keep_if_done(task, seconds);
      const bool is_told = !note.empty() && (options_.resume || seconds) && parallel::group() == 0;
      if (is_told) observer_.tell(Note{note});
    }
  }

  /// Refuses tasks that may not fit into the memory. The tasks themselves do not check this again.
  void require_memory_of_tasks() {
    std::vector<std::size_t> tasks;
    for (std::size_t task = 0; task < sweep_.tasks.size(); ++task) {
      if (!options_.resume || result_[task].state != TaskState::done) tasks.push_back(task);
    }
    require_memory(sweep_, tasks, parallel::available_memory());
    for (auto& options : options_of_) options.solve.ignore_memory = true;
  }

  void keep_if_done(std::size_t task, std::optional<double> seconds) {
    if (seconds) result_[task] = {TaskState::done, stored_curves(task), *seconds};
  }

  /// Whether a task belongs to this group of processes; the groups take the tasks in turn.
  [[nodiscard]] static bool is_ours(std::size_t task) {
    return task % static_cast<std::size_t>(parallel::groups()) == static_cast<std::size_t>(parallel::group());
  }

  /// Exchanges the results of the tasks between the groups.
  void exchange() {
    nlohmann::json ours = nlohmann::json::array();
    for (std::size_t task = 0; task < result_.size(); ++task) {
      if (is_ours(task)) ours.push_back({result_[task].state, result_[task].seconds, result_[task].error});
    }
    const auto told = parallel::gather(ours.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    for (std::size_t task = 0; task < result_.size(); ++task) {
      if (is_ours(task)) continue;
      const auto theirs = nlohmann::json::parse(told[task % told.size()])[task / told.size()];
      result_[task].state = theirs[0].get<TaskState>();
      result_[task].seconds = theirs[1].get<double>();
      result_[task].error = theirs[2].get<std::string>();
    }
    by_first_group([&] {
      for (std::size_t task = 0; task < result_.size(); ++task) {
        const bool is_done = result_[task].state == TaskState::done;
        if (is_done && !is_ours(task)) result_[task].curves = stored_curves(task);
      }
    });
  }

  /// Looks for tasks that the other groups have completed.
  void poll_other_groups() {
    for (std::size_t task = 0; task < sweep_.tasks.size(); ++task) {
      if (is_ours(task) || result_[task].state != TaskState::waiting) continue;
      const auto record = read_study_record(directory_of(task));
      if (record.is_complete_run_of(sweep_.tasks[task].study)) keep_if_done(task, record.wall_time);
    }
  }

  /// The stages of a task that differs from an earlier task in temperatures alone, computed from the reduced responses
  /// of the earlier one. Nothing where there is no such task, or where the responses cannot be read or do not cover the
  /// materials: then the task is run. With several processes all tasks are run, since some processes may not yet see
  /// files that another one has moved.
  [[nodiscard]] std::optional<SharedStages> answered(std::size_t task) const {
    const auto earlier = task_that_answers(sweep_, task);
    if (!earlier || !parallel::is_alone() || result_[*earlier].state != TaskState::done) return std::nullopt;
    try {
      const auto& study = sweep_.tasks[task].study;
      return SharedStages(study, answered_stages(study, directory_of(*earlier)), sweep_.tasks[*earlier].name);
    } catch (const InputError&) {
      return std::nullopt;
    } catch (const FileError&) {
      return std::nullopt;
    }
  }

  void run(std::size_t task) {
    try {
      auto answers = answered(task);
      ResultTransaction results(sweep_.tasks[task].study, directory_of(task), options_of_[task]);
      const auto done = run_study(results, observer_, answers ? *answers : shared_);
      result_[task] = {TaskState::done, curves_of(done), done.seconds.value_or(0.0)};
    } catch (const NumericalError& error) {
      fail(task, error);
    } catch (const DirectoryInUse&) {
      throw;  // another process is running the task, which has not failed
    } catch (const InputError& error) {
      fail(task, error);
    }
  }

  void fail(std::size_t task, const Error& error) {
    result_[task] = {.state = TaskState::failed, .error = error.what()};
    observer_.tell(TaskFailed{sweep_, task, error.what()});
  }

  void write() {
    by_first_group([&] {
      if (parallel::groups() > 1) poll_other_groups();
      write_sweep_tables(directory_, sweep_, result_);
      write_record();
      write_sweep_plot(directory_, sweep_, result_);
      write_sweep_report(directory_, result_);
    });
  }

  void write_record() const {
    std::vector<std::vector<std::string>> replaceable;
    for (const auto& options : options_of_) replaceable.push_back(options.replaceable);
    write_sweep_record(directory_, sweep_, result_, replaceable);
  }

  const Sweep& sweep_;
  const std::filesystem::path& directory_;
  const RunOptions& options_;
  const RunObserver& observer_;
  SharedStages shared_;
  std::vector<RunOptions> options_of_;  ///< options of each task
  SweepResult result_;
};

}  // namespace

SweepResult run_sweep(const Sweep& sweep, const std::filesystem::path& directory, const RunOptions& options,
                      const RunObserver& observer) {
  return SweepRun(sweep, directory, options, observer).run();
}

}  // namespace breccia
