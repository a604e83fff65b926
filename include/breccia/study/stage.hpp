#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "breccia/study/filler.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// Name of an earlier stage whose result is the matrix.
struct EarlierStage {
  std::string name;
};

/// The matrix of a stage: a material, or the result of an earlier stage.
using StageMatrix = std::variant<Material, EarlierStage>;

/// The name of the material or of the earlier stage.
const std::string& name_of(const StageMatrix& matrix);

/// A microstructure, on its scale, and the grids on which it is tested.
struct Stage {
  std::string name;  ///< name of the stage and of its directory
  StageMatrix matrix;
  double side = 0.0;                       ///< side of the square or cubic box [m]
  int cells = 0;                           ///< cells per side of the finest grid
  std::vector<int> coarser_cells = {};     ///< cells per side of the coarser grids, rising, for extrapolation
  std::vector<Filler> fillers = {};        ///< the kinds of particles in the box
  PackingMethod packing = {};              ///< of the particles of all fillers together; unused without a filler
  std::vector<std::string> warnings = {};  ///< warnings about the deck, without the name of the stage
  int dimensions = 2;                      ///< of the box: 2 (plane strain) or 3; the same for all stages of a study

  /// Side of a cell of the finest grid [m].
  [[nodiscard]] double cell_size() const { return side / cells; }
  /// The particles of a list (an explicit packing), which have no sizes; nullptr for any other packing.
  [[nodiscard]] const ExplicitPacking* listed() const { return std::get_if<ExplicitPacking>(&packing); }
  /// The grains that fill the box; nullptr for particles.
  [[nodiscard]] const LaguerrePacking* grains() const { return std::get_if<LaguerrePacking>(&packing); }
  /// The image that fills a box of two dimensions; nullptr for particles and grains.
  [[nodiscard]] const LabelImage<2>* image() const {
    const auto* packing_of_pixels = std::get_if<ImagePacking>(&packing);
    return packing_of_pixels == nullptr ? nullptr : packing_of_pixels->image.get();
  }
  /// The image that fills a box of three dimensions; nullptr for particles and grains.
  [[nodiscard]] const LabelImage<3>* stack() const {
    const auto* packing_of_voxels = std::get_if<ImagePacking>(&packing);
    return packing_of_voxels == nullptr ? nullptr : packing_of_voxels->stack.get();
  }
  /// Whether the box is filled by an image of either kind.
  [[nodiscard]] bool has_image() const { return image() != nullptr || stack() != nullptr; }
  /// Whether grains fill the box and half a film runs along its hard walls.
  [[nodiscard]] bool has_films_along_walls() const;
  /// Whether the particles are packed at random.
  [[nodiscard]] bool is_random() const {
    return std::holds_alternative<LubachevskyStillingerPacking>(packing) ||
           std::holds_alternative<RandomSequentialPacking>(packing);
  }
  /// Whether particles or grains are placed at random, by a seed.
  [[nodiscard]] bool has_seed() const { return seed().has_value(); }
  /// The seed; nothing where particles or grains are not placed at random.
  [[nodiscard]] std::optional<std::uint64_t> seed() const;
  /// Whether the box goes on beyond its sides.
  [[nodiscard]] bool is_periodic() const;
  /// Cells per side of all grids, rising.
  [[nodiscard]] std::vector<int> grids() const;
};

/// "100 x 100", or "100 x 100 x 100" in three dimensions.
std::string cells_in_words(const Stage& stage, int cells);

/// The materials that a stage names, each once: its matrix, unless that is an earlier stage, then its fillers and their
/// coatings.
std::vector<Material> named_materials(const Stage& stage);

}  // namespace breccia
