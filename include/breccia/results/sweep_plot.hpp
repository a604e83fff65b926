#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "breccia/deck/sweep.hpp"
#include "breccia/results/sweep_result.hpp"

namespace breccia {

/// Writes `sweep.svg`, the shear modulus of the last stage in all finished tasks. Writes nothing if no task is finished
/// or gnuplot is missing. Returns why the plot is left out if gnuplot could not draw it. Throws FileError.
std::optional<std::string> write_sweep_plot(const std::filesystem::path& directory, const Sweep& sweep,
                                            const SweepResult& result);

}  // namespace breccia
