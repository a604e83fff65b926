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

/// How each task is run. A sweep that resumes may replace the results of other studies in the directories of those
/// tasks that the tables of the directory name already: the run that began the sweep was to overwrite them.
std::vector<RunOptions> options_of_tasks(const Sweep& sweep, const std::filesystem::path& directory,
                                         const RunOptions& options);

/// Writes `sweep.csv` and `spread.csv`, each if it has rows, and `sweep.json`; a table without rows is removed.
void write_sweep_tables(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

/// Writes `sweep.svg`, the shear modulus of the last stage in all tasks, once one is done. Writes nothing where gnuplot
/// cannot draw.
void write_sweep_plot(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

/// Writes `report.html` beside `sweep.json`, which write_sweep_tables writes.
void write_sweep_report(const std::filesystem::path& directory, const SweepResult& result);

}  // namespace breccia
