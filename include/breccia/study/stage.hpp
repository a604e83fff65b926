#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "breccia/study/filler.hpp"
#include "breccia/viscoelasticity/material.hpp"

namespace breccia {

/// An earlier stage, by name, whose result serves as a material.
struct EarlierStage {
  std::string name;
};

/// What lies between the particles of a stage.
using StageMatrix = std::variant<Material, EarlierStage>;

/// The name of the material or stage.
const std::string& name_of(const StageMatrix& matrix);

/// A microstructure to be tested.
struct Stage {
  std::string name;  ///< also that of its directory
  StageMatrix matrix;
  double side = 0.0;                    ///< of the square box [m]
  int cells = 0;                        ///< per side; of the finest grid where there are several
  std::vector<int> coarser_cells = {};  ///< per side of the coarser grids from which curves are extrapolated, rising
  std::optional<Filler> filler = {};
  std::vector<std::string> warnings = {};  ///< what is doubtful in the deck itself, without the name of the stage

  /// Side of a cell of the finest grid [m].
  [[nodiscard]] double cell_size() const { return side / cells; }
  /// Cells per side of all grids, rising.
  [[nodiscard]] std::vector<int> grids() const;
};

}  // namespace breccia
