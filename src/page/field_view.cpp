#include "page/field_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/films/film_fields.hpp"

#include "io/hdf5.hpp"
#include "page/film_pieces.hpp"
#include "page/page_bytes.hpp"
#include "report/volume_colours.hpp"
#include "results/volume_quantities.hpp"

namespace breccia {
namespace {

using Json = nlohmann::ordered_json;

/// Cubic blocks of the cells of a cube; the last ones along an axis may have fewer.
struct CellBlocks {
  std::size_t cells = 0;  ///< cells of the cube along an axis
  std::size_t side = 1;   ///< cells along the side of a block

  [[nodiscard]] std::size_t along() const { return (cells + side - 1) / side; }
  [[nodiscard]] std::size_t count() const { return along() * along() * along(); }
  /// The block of a cell in a layer of cells, which are numbered with x fastest.
  [[nodiscard]] std::size_t block_of(std::size_t layer, std::size_t cell) const {
    return (layer / side * along() + cell / cells / side) * along() + cell % cells / side;
  }
};

CellBlocks blocks_of(const std::filesystem::path& path, const Hdf5Reader& file, std::size_t most_along) {
  const auto shape = file.shape("/VTKHDF/CellData/material");
  const auto count = shape.size() == 1 ? shape.front() : 0;
  const auto cells = static_cast<std::size_t>(std::lround(std::cbrt(static_cast<double>(count))));
  if (cells == 0 || cells * cells * cells != count) {
    throw FileError(fmt::format("{}: {} cells do not fill a cube", path.string(), count));
  }
  return {.cells = cells, .side = (cells + most_along - 1) / most_along};
}

/// The place in the file of each component of a tensor xx, yy, zz, yz, zx, xy.
constexpr std::array<std::size_t, 6> from_vtk = {0, 1, 2, 4, 5, 3};

/// Means of a tensor over the blocks. The file is read layer by layer, since it may be larger than the memory.
std::vector<CellTensor> block_means(const Hdf5Reader& file, const std::string& name, const CellBlocks& blocks) {
  std::vector<CellTensor> means(blocks.count());
  std::vector<double> cells(blocks.count(), 0.0);
  const auto in_layer = blocks.cells * blocks.cells;
  for (std::size_t layer = 0; layer < blocks.cells; ++layer) {
    const auto values = file.read_numbers("/VTKHDF/CellData/" + name, layer * in_layer, in_layer);
    if (values.size() != in_layer * from_vtk.size()) {
      throw FileError(fmt::format("{}: expected {} components", name, from_vtk.size()));
    }
    for (std::size_t cell = 0; cell < in_layer; ++cell) {
      const auto block = blocks.block_of(layer, cell);
      cells[block] += 1.0;
      for (std::size_t i = 0; i < from_vtk.size(); ++i) means[block][i] += values[from_vtk.size() * cell + from_vtk[i]];
    }
  }
  for (std::size_t block = 0; block < means.size(); ++block) {
    for (double& component : means[block]) component /= cells[block];
  }
  return means;
}

/// The phase of the first cell of each block.
std::vector<std::uint8_t> phases_of_blocks(const Hdf5Reader& file, const CellBlocks& blocks) {
  std::vector<std::uint8_t> phases;
  phases.reserve(blocks.count());
  const auto all = file.read_integers("/VTKHDF/CellData/material");
  for (std::size_t z = 0; z < blocks.cells; z += blocks.side) {
    for (std::size_t y = 0; y < blocks.cells; y += blocks.side) {
      for (std::size_t x = 0; x < blocks.cells; x += blocks.side) {
        phases.push_back(static_cast<std::uint8_t>(all[(z * blocks.cells + y) * blocks.cells + x]));
      }
    }
  }
  return phases;
}

Json json_of(const VolumeQuantity& quantity) {
  const auto [from, to, colours] = volume_colours(quantity.scale, quantity.values);
  return {{"words", quantity.words},
          {"unit_size", quantity.unit_size},
          {"scale", quantity.scale == ColourScale::logarithmic ? "logarithmic" : "linear"},
          {"from", from},
          {"to", to},
          {"values", bytes_for_page(colours)}};
}

Json view_of_cells(const std::filesystem::path& path, const Hdf5Reader& fields, Load load, Boundary boundary,
                   std::size_t most_along) {
  const auto blocks = blocks_of(path, fields, most_along);
  const std::vector<double> volumes(blocks.count(), 1.0);
  return {{"cells", blocks.along()},
          {"stress", json_of(stress_in_cells(block_means(fields, "stress_Pa", blocks), volumes, load, boundary))},
          {"strain", json_of(strain_in_cells(block_means(fields, "strain", blocks), volumes, load))},
          {"material", {{"values", bytes_for_page(phases_of_blocks(fields, blocks))}}}};
}

/// A tensor of the pieces of grains and films.
std::vector<CellTensor> tensors_of(const Hdf5Reader& file, const std::string& name, const FilmPieces& pieces) {
  const auto values = file.read_numbers("/VTKHDF/CellData/" + name);
  if (values.size() != from_vtk.size() * pieces.count()) {
    throw FileError(fmt::format("{}: expected {} components of each piece", name, from_vtk.size()));
  }
  std::vector<CellTensor> tensors(pieces.count());
  for (std::size_t piece = 0; piece < tensors.size(); ++piece) {
    for (std::size_t i = 0; i < from_vtk.size(); ++i) tensors[piece][i] = values[from_vtk.size() * piece + from_vtk[i]];
  }
  return tensors;
}

/// What is drawn at a piece of grains and films: its phase, or the number after those of binder and grains where a film
/// is debonded.
std::uint8_t drawn_phase(FilmPart part) {
  constexpr std::uint8_t of_binder = 0, of_grain = 1, of_debonded = 2;
  if (part == FilmPart::grain) return of_grain;
  const bool is_debonded = part == FilmPart::gap || part == FilmPart::slip || part == FilmPart::spring;
  return is_debonded ? of_debonded : of_binder;
}

Json view_of_films(const std::filesystem::path& path, const Hdf5Reader& file, double side, Load load, Boundary boundary,
                   std::size_t along) {
  const auto pieces = film_pieces(path.string(), file);
  const auto volumes = volumes_of(pieces);
  auto piece_of_cell = pieces_in_cells(pieces, side, along);
  const auto missed = std::ranges::count(piece_of_cell, pieces.count());
  constexpr std::int64_t most_missed = 1000;  // one of so many may be missed by rounding, and looks like the one before
  if (missed * most_missed > static_cast<std::int64_t>(piece_of_cell.size())) {
    throw FileError(fmt::format("{}: the pieces do not fill a box of {} m", path.string(), side));
  }
  std::size_t before = 0;
  for (auto& piece : piece_of_cell) before = piece = piece == pieces.count() ? before : piece;
  const auto in_cells = [&](VolumeQuantity of_pieces) {
    std::vector<double> values;
    values.reserve(piece_of_cell.size());
    for (const auto piece : piece_of_cell) values.push_back(of_pieces.values[piece]);
    of_pieces.values = std::move(values);
    return json_of(of_pieces);
  };
  std::vector<std::uint8_t> phases;
  phases.reserve(piece_of_cell.size());
  for (const auto piece : piece_of_cell) phases.push_back(drawn_phase(pieces.parts[piece]));
  return {{"cells", along},
          {"stress", in_cells(stress_in_cells(tensors_of(file, "stress_Pa", pieces), volumes, load, boundary))},
          {"strain", in_cells(strain_in_cells(tensors_of(file, "strain", pieces), volumes, load))},
          {"material", {{"values", bytes_for_page(phases)}}}};
}

}  // namespace

Json field_view(const std::filesystem::path& file, double side, Load load, Boundary boundary, std::size_t most_along) {
  const Hdf5Reader fields(file);
  if (fields.has("/VTKHDF/CellData/part")) return view_of_films(file, fields, side, load, boundary, most_along);
  return view_of_cells(file, fields, load, boundary, most_along);
}

}  // namespace breccia
