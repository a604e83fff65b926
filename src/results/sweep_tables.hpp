#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/study/sweep.hpp"

#include "results/sweep_result.hpp"

namespace breccia {

/// Writes `sweep.csv` and `spread.csv` and, of a study in frequency, `sweep_dynamic.csv` and `spread_dynamic.csv`; a
/// table that has no rows is removed. Throws FileError.
void write_sweep_tables(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

/// Writes `sweep.json`: the state of each task and, for each unfinished task, the earlier results that it may replace,
/// identified by the hashes of their records. Throws FileError.
void write_sweep_record(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result,
                        const std::vector<std::vector<std::string>>& replaceable);

}  // namespace breccia
