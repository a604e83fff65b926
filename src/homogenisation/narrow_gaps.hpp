#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Gaps between particles with fewer cells are narrow.
inline constexpr double cells_in_narrow_gaps = 1.5;

/// Cells in a gap from which on cells without flow resolve it. Points bridge narrower gaps. In a gap of one mixed cell
/// an incompressible matrix slides, but cannot be squeezed out (theory, section 2).
constexpr double cells_in_resolved_gaps(Mixing mixing) {
  return mixing == Mixing::points ? 3.0 : cells_in_narrow_gaps;
}

/// Whether the gaps of a stage are so narrow on its finest grid that flow through them serves better than cells in
/// series: below one and a half cells between particles, below 1.4 cells between grains (docs/gaps-under-a-cell.md).
[[nodiscard]] bool has_narrow_gaps(const Stage& stage, const StageMicrostructure& packed);

/// Whether gaps between spheres are so narrow, below a cell of the finest grid and below a tenth of the mean diameter,
/// that the error of cells in series has no rule (theory, Eq. 43c).
[[nodiscard]] bool has_spheres_that_almost_touch(const Stage& stage, const StageMicrostructure& packed);

/// The number of cells across the mean sphere from which on the narrowest gap is a cell wide; 0 where the gap is a
/// tenth of the mean diameter or wider.
[[nodiscard]] double least_cells_across_spheres(const StageMicrostructure& packed);

/// The narrowest gap, over the mean diameter of the particles [-], with which flow through gaps was tested.
[[nodiscard]] double narrowest_tested_gap(int dimensions);

/// Whether the gaps between particles are narrower than those with which flow was tested. Moduli of particles that
/// touch do not converge with finer grids.
[[nodiscard]] bool has_particles_that_touch(const Stage& stage, const StageMicrostructure& packed);

/// Whether all fillers of a stage, and their coatings, are softer than its matrix at all times. The matrix need not be
/// squeezed out of the gaps between them, which carry load like films.
[[nodiscard]] bool has_soft_fillers(const Study& study, const Stage& stage);

/// The mixing that the cells of a stage are expected to have: Mixing::flow is Mixing::series where gaps are wide, and
/// where a filler or a coating is not stiffer than the matrix at all times.
[[nodiscard]] Mixing mixing_of(const Study& study, const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia
