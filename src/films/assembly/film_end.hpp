#pragma once

#include <array>
#include <vector>

#include "films/mesh/film_network.hpp"

namespace breccia::films {

/// The resistance of the bend where a film flows into a junction of three films of its thickness, as a length of film
/// in units of the thickness (theory, Eq. 63). `angles` [degrees] are the angles to the two other films.
[[nodiscard]] double end_length(const std::array<double, 2>& angles);

/// The lengths of the bends at the start and the end of every film, by the angles of their junctions. Where more than
/// three films meet, or the junction is at a wall, the length for 120 degrees is taken.
[[nodiscard]] std::vector<std::array<double, 2>> end_lengths(const FilmNetwork& network);

}  // namespace breccia::films
