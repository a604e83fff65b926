#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "breccia/microstructure/particle.hpp"
#include "breccia/microstructure/vector.hpp"
#include "breccia/study/stage.hpp"

namespace breccia {

/// The shape of a particle of a filler with this diameter of equal area [m]: the shape of the filler, or a circle.
Shape shape_of(const Filler& filler, double diameter);

/// The axes [m] of a particle of a filler in three dimensions with this diameter of equal volume [m], the axis of
/// revolution first. Throws InputError where the shape is two-dimensional.
Vector<3> axes_of(const Filler& filler, double diameter);

/// The mistakes in the shape of a filler, a line each: an aspect beyond its limits, corners that are not those of a
/// convex polygon, an angle that is not finite.
std::vector<std::string> mistakes_of_shape(const FillerShape& shape);

/// A shape in words: "ellipses of aspect 1.5, all at 30 deg", "polygons of 5 corners"; in three dimensions "ellipsoids
/// of revolution of aspect 1.5".
std::string in_words(const FillerShape& shape, int dimensions);

/// Thickness of the coating of each particle [m] of these fillers; empty where no particle has a coating.
std::vector<double> coatings_of(const Stage& stage, const std::vector<std::size_t>& fillers, std::size_t particles);

}  // namespace breccia
