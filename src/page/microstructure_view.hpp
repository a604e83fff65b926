#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace breccia {

/// The data that the page draws of the microstructure of a stage in three dimensions, from the files in its directory:
/// - of spheres and ellipsoids {"particles": {"count": ..., "listed": ..., "columns": {"x_m": ..., ...}}}, the columns
///   of `microstructure.csv` (numbers_for_page), of at most `most_drawn_particles` the largest ones;
/// - of grains and voxels {"phases": {"cells": [...], "values": ...}}, the numbers of phases in `labels.npy`
///   (bytes_for_page) of at most 128 points along each axis.
/// Null if neither file exists. Throws FileError, and InputError when a file is not as Breccia writes it.
nlohmann::ordered_json microstructure_view(const std::filesystem::path& directory);

}  // namespace breccia
