#pragma once

#include <span>
#include <string>
#include <vector>

#include "breccia/study/stage.hpp"
#include "breccia/viscoelasticity/shifted_material.hpp"

namespace breccia {

// Rules for a stage that the deck reader and require_sound share. Each function returns the mistakes, a line each,
// without their locations.

/// A name must be fit for a directory and not be the name of a file of results, an earlier stage or a material. An
/// empty name makes no mistake here.
std::vector<std::string> mistakes_of_name(const std::string& name, std::span<const Stage> earlier,
                                          const std::vector<ShiftedMaterial>& materials);

/// The gap between particles must be narrower than the box, of the given side [m].
std::vector<std::string> mistakes_of_gap(const Filler& filler, double side);

/// Particles with their coating must be smaller than the box, of the given side [m]; those of a regular packing must
/// not touch.
std::vector<std::string> mistakes_of_diameters(const Filler& filler, const StagePacking& packing, double side);

/// The fractions of the fillers of a stage must add up to less than 1.
std::vector<std::string> mistakes_of_fractions(const Stage& stage);

/// The phases of a stage are distinguished by the names of their materials where there are several fillers or coatings
/// (phase_names), so that no such material may have the name of another phase.
std::vector<std::string> mistakes_of_phases(const Stage& stage);

/// A direction across which films are debonded has as many components as the stage has dimensions, not all of them
/// zero. None is no mistake.
std::vector<std::string> mistakes_of_normal(const std::vector<double>& normal, int dimensions);

/// Two or three grids, with rising numbers of cells per side, are needed for an extrapolation.
bool can_be_extrapolated(const std::vector<int>& grids);

}  // namespace breccia
