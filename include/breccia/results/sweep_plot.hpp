#pragma once

#include <filesystem>

#include "breccia/deck/sweep.hpp"
#include "breccia/results/sweep_result.hpp"

namespace breccia {

/// Writes `sweep.svg`, the shear modulus of the last stage in all finished tasks. Writes nothing if no task is finished
/// or gnuplot cannot draw.
void write_sweep_plot(const std::filesystem::path& directory, const Sweep& sweep, const SweepResult& result);

}  // namespace breccia
