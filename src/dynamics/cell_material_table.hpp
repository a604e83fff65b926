#pragma once

#include <vector>

#include "breccia/discretisation/phase.hpp"
#include "breccia/viscoelasticity/material.hpp"

#include "dynamics/cell_row_kernel.hpp"

namespace breccia::dynamics {

/// The materials of whole cells with averaged volumetric strains, for the time step [s] of a run.
template <int dim>
class CellMaterialTable {
 public:
  CellMaterialTable(const std::vector<Material>& materials, double time_step);
  // The steps point into the lists of terms.
  CellMaterialTable(const CellMaterialTable&) = delete;
  CellMaterialTable& operator=(const CellMaterialTable&) = delete;
  CellMaterialTable(CellMaterialTable&&) noexcept = default;
  CellMaterialTable& operator=(CellMaterialTable&&) noexcept = default;
  ~CellMaterialTable() = default;

  /// The material of a phase or a mixture, by PhaseIndex; one without stiffness for no_phase.
  [[nodiscard]] const CellMaterialStep& operator[](PhaseIndex phase) const noexcept {
    return phase == no_phase ? steps_.back() : steps_[phase];
  }

 private:
  std::vector<std::vector<TermStep>> terms_;  ///< terms of steps_: shear, then dilatational
  std::vector<CellMaterialStep> steps_;
};

}  // namespace breccia::dynamics
