#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "breccia/microstructure/ellipsoid.hpp"
#include "breccia/microstructure/particle.hpp"
#include "breccia/tables/measured_table.hpp"

#include "io/file_mistakes.hpp"

namespace breccia {

// Readers of particles of other shapes than discs in the files of an explicit packing. `side` is the side of the box
// [m]; where it is not a number, every centre is accepted.

/// Whether a table has a column of ellipses.
bool lists_ellipses(const MeasuredTable& table);

/// The ellipses of a table with the columns x, y, axis_1, axis_2 and angle. Adds the mistakes in rows to `mistakes`;
/// throws InputError where a column is missing.
std::vector<Particle> read_ellipses(const MeasuredTable& table, double side, FileMistakes& mistakes);

/// Whether a table has a column of ellipsoids.
bool lists_ellipsoids(const MeasuredTable& table);

/// The ellipsoids of a table with the columns x, y, z, axis_1, axis_2, axis_3, azimuth, elevation and roll. Adds the
/// mistakes in rows to `mistakes`; throws InputError where a column is missing.
std::vector<Ellipsoid> read_ellipsoids(const MeasuredTable& table, double side, FileMistakes& mistakes);

/// Polygons, with the filler number of each.
struct ListedPolygons {
  std::vector<Particle> particles;
  std::vector<std::size_t> fillers;
};

/// The polygons of a file with the columns particle, x, y and, with several fillers, filler: a row for each corner.
/// Throws InputError with all mistakes in the file.
ListedPolygons read_polygons(const std::filesystem::path& file, double side, std::size_t fillers);

/// The number of the filler of each row: 0 where there is one filler. Adds numbers that no filler has, and a missing
/// column, to `mistakes`.
std::vector<std::size_t> read_filler_numbers(const MeasuredTable& table, std::size_t fillers, FileMistakes& mistakes);

}  // namespace breccia
