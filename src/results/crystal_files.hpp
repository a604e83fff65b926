#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/stage.hpp"

#include "tables/csv.hpp"

namespace breccia {

/// The columns of Bunge's Euler angles that a list of orientations has: `phi1_deg`, `phi_deg` and `phi2_deg`.
[[nodiscard]] std::vector<CsvColumn> columns_of_angles(std::span<const EulerAngles> angles);

/// Writes `crystals.csv`, the orientations of the particles that are crystals, in the form that `orientations` reads;
/// nothing where there are none. Grains have theirs in the table of the grains. Throws FileError.
void write_crystals(const std::filesystem::path& directory, const Stage& stage,
                    const StageMicrostructure& microstructure);

}  // namespace breccia
