#pragma once

#include <filesystem>

#include "breccia/deck/sweep.hpp"
#include "breccia/results/sweep_result.hpp"

namespace breccia {

/// Writes `sweep.csv` and `spread.csv`, each if it has rows, and `sweep.json`; a table without rows is removed. Throws
/// FileError.
void write_sweep_tables(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

/// Writes `sweep.svg`, the shear modulus of the last stage in all tasks, once one is done. Writes nothing where gnuplot
/// cannot draw.
void write_sweep_plot(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

/// Writes `report.html` beside `sweep.json`, which write_sweep_tables writes.
void write_sweep_report(const std::filesystem::path& directory, const SweepResult& result);

}  // namespace breccia
