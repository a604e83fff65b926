#pragma once

#include "breccia/homogenisation/stage_microstructure.hpp"
#include "breccia/study/study.hpp"

namespace breccia {

/// Gaps between particles with fewer cells are narrow.
inline constexpr double cells_in_narrow_gaps = 1.5;

/// Whether the gaps of a stage are so narrow on its finest grid that flow through them serves better than cells in
/// series: below one and a half cells between particles, below 1.4 cells between grains (docs/gaps-under-a-cell.md).
[[nodiscard]] bool has_narrow_gaps(const Stage& stage, const StageMicrostructure& packed);

/// Whether gaps between spheres are narrower than those with which the rule for the error of cells in series was
/// measured (theory, Eq. 43c): below a cell of the finest grid and below 3 % of the mean diameter.
[[nodiscard]] bool has_spheres_that_almost_touch(const Stage& stage, const StageMicrostructure& packed);

/// Whether all fillers of a stage, and their coatings, are softer than its matrix at all times. The matrix need not be
/// squeezed out of the gaps between them, which carry load like films.
[[nodiscard]] bool has_soft_fillers(const Study& study, const Stage& stage);

/// The mixing that the cells of a stage are expected to have: Mixing::flow is Mixing::series where gaps are wide, and
/// where a filler or a coating is not stiffer than the matrix at all times.
[[nodiscard]] Mixing mixing_of(const Study& study, const Stage& stage, const StageMicrostructure& packed);

}  // namespace breccia
