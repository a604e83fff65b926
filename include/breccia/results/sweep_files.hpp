#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "breccia/deck/sweep.hpp"
#include "breccia/results/sweep_result.hpp"

namespace breccia {

/// Writes `sweep.csv` and `spread.csv`, each if it has rows; a table without rows is removed. Throws FileError.
void write_sweep_tables(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

/// Writes `sweep.json`: the state of each task, and of those that are not done which results they may replace, by the
/// hashes of their records. Throws FileError.
void write_sweep_record(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result,
                        const std::vector<std::vector<std::string>>& replaceable);

/// Writes `sweep.svg`, the shear modulus of the last stage in all tasks, once one is done. Writes nothing where there
/// is no gnuplot. Returns why the plot is left out where gnuplot could not draw it. Throws FileError.
std::optional<std::string> write_sweep_plot(const std::filesystem::path& directory, const Sweep& sweep,
                                            const SweepResult& result);

/// Writes `report.html` beside `sweep.json`, which write_sweep_record writes.
void write_sweep_report(const std::filesystem::path& directory, const SweepResult& result);

}  // namespace breccia
