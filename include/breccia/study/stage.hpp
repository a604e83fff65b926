#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "breccia/nested_variant.hpp"
#include "breccia/study/filler.hpp"
#include "breccia/study/film_bonds.hpp"
#include "breccia/study/packing_method.hpp"
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
  double side = 0.0;                    ///< side of the square or cubic box [m]
  int cells = 0;                        ///< cells per side of the finest grid
  std::vector<int> coarser_cells = {};  ///< cells per side of the coarser grids, rising, for extrapolation
  std::vector<Filler> fillers = {};     ///< the kinds of particles in the box
  /// The packing of the particles of all fillers together. Without a filler only its number of dimensions matters:
  /// PackingMethod<2>() for a square (plane strain) or PackingMethod<3>() for a cube. All stages of a study have the
  /// same number of dimensions.
  StagePacking packing = {};
  std::optional<FilmBonds> bonds = {};  ///< with the model of grains and films; nothing where all films are bonded

  /// Dimensions of the box, 2 or 3.
  [[nodiscard]] int dimensions() const;
  /// Side of a cell of the finest grid [m].
  [[nodiscard]] double cell_size() const { return side / cells; }
  /// The packing, if it is of this method, such as RegularPacking; nullptr for any other.
  template <class Method>
  [[nodiscard]] const Method* packed_by() const {
    return find_alternative<Method>(packing);
  }
  template <class Method>
  [[nodiscard]] Method* packed_by() {
    return find_alternative<Method>(packing);
  }
  /// The method of the packing.
  [[nodiscard]] PackingName packing_name() const;
  /// Whether the particles are those of a list, which have no sizes.
  [[nodiscard]] bool is_listed() const { return packing_name() == PackingName::listed; }
  /// Whether grains fill the box.
  [[nodiscard]] bool has_grains() const { return packing_name() == PackingName::laguerre; }
  /// Whether an image fills the box.
  [[nodiscard]] bool has_image() const { return packing_name() == PackingName::image; }
  /// Whether a filler is void.
  [[nodiscard]] bool has_voids() const;
  /// Whether the particles of a filler are crystals.
  [[nodiscard]] bool has_crystals() const;
  /// Whether hard walls cut the grains that fill the box.
  [[nodiscard]] bool has_cut_grains() const;
  /// Whether grains fill the box and half a film runs along its hard walls.
  [[nodiscard]] bool has_films_along_walls() const;
  /// Whether the particles are packed at random, so that they keep gaps.
  [[nodiscard]] bool is_random() const;
  /// Whether particles or grains are placed at random, by a seed.
  [[nodiscard]] bool has_seed() const { return seed().has_value(); }
  /// The seed; nothing where particles or grains are not placed at random.
  [[nodiscard]] std::optional<std::uint64_t> seed() const;
  /// Whether the content of the box continues periodically beyond its sides.
  [[nodiscard]] bool is_periodic() const;
  /// Cells per side of all grids, rising.
  [[nodiscard]] std::vector<int> grids() const;
};

/// A grid of the stage in words: "100 x 100", or "100 x 100 x 100" in three dimensions.
std::string cells_in_words(const Stage& stage, int cells);

/// The materials that a stage names, each once: its matrix, unless that is an earlier stage, then its fillers and their
/// coatings.
std::vector<Material> named_materials(const Stage& stage);

}  // namespace breccia
