#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "breccia/films/film_fields.hpp"

#include "io/hdf5.hpp"

namespace breccia {

/// The cells of the fields of grains and films in space, as tetrahedra and wedges.
struct FilmPieces {
  std::vector<std::array<double, 3>> points;  ///< [m]
  std::vector<std::int64_t> corners;          ///< numbers of points, one piece after the other
  std::vector<std::int64_t> offsets;          ///< the first corner of each piece, and the number of all corners
  std::vector<FilmPart> parts;                ///< part by piece

  [[nodiscard]] std::size_t count() const noexcept { return parts.size(); }
};

/// The pieces in a file of fields of this name. Throws FileError when the file cannot be read, or holds other pieces
/// than tetrahedra and wedges of grains and films.
[[nodiscard]] FilmPieces film_pieces(const std::string& name, const Hdf5Reader& file);

/// Volumes of the pieces [m^3].
[[nodiscard]] std::vector<double> volumes_of(const FilmPieces& pieces);

/// The piece at the middle of each cell of a periodic cube, x fastest, which has a side [m] and a number of cells along
/// it. Binder is drawn half a cell larger all around, so that no film is lost. A cell that no piece covers has the
/// number of pieces.
[[nodiscard]] std::vector<std::size_t> pieces_in_cells(const FilmPieces& pieces, double side, std::size_t along);

}  // namespace breccia
