#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "breccia/study/sweep.hpp"

namespace breccia {

/// The curves of a run.
std::vector<TaskCurve> curves_of(const StudyResult& result);

/// The curves that an earlier run has left in a directory. Throws FileError or InputError when they cannot be read.
std::vector<TaskCurve> read_curves(const std::filesystem::path& directory);

/// Have two tasks the same values of all keys but some?
bool differ_only_in(const Sweep& sweep, const SweepTask& one, const SweepTask& other,
                    const std::function<bool(const SweptKey&)>& keys);

/// How each task is run. A sweep that is to overwrite may replace the results that are in the directories of its tasks
/// when it begins, and one that resumes those of them that `sweep.json` still names: not what others put there since.
std::vector<RunOptions> options_of_tasks(const Sweep& sweep, const std::filesystem::path& directory,
                                         const RunOptions& options);

/// Writes `sweep.csv` and `spread.csv`, each if it has rows; a table without rows is removed.
void write_sweep_tables(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

/// Writes `sweep.json`: what has become of the tasks, and of those that are not done which results they may replace.
void write_sweep_record(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result,
                        const std::vector<RunOptions>& options_of_tasks);

/// Writes `sweep.svg`, the shear modulus of the last stage in all tasks, once one is done. Writes nothing where gnuplot
/// cannot draw.
void write_sweep_plot(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

/// Writes `report.html` beside `sweep.json`, which write_sweep_record writes.
void write_sweep_report(const std::filesystem::path& directory, const SweepResult& result);

}  // namespace breccia
