#pragma once

#include <filesystem>
#include <string>

#include "breccia/study/sweep.hpp"

#include "results/sweep_result.hpp"

namespace breccia {

/// Writes `sweep.svg`, the shear modulus of the last stage in all finished tasks over time or, of a study in frequency,
/// its absolute value over frequency, with what was measured. If no task is finished, writes
/// nothing and removes the file. Throws FileError.
void write_sweep_plot(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

}  // namespace breccia
