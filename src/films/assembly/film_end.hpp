#pragma once

#include <array>
#include <vector>

#include "mesh/film_network.hpp"

namespace breccia::films {

/// The resistance of the bend where a film flows into a junction of three films of its thickness, as a length of film
/// in units of the thickness (theory, Eq. 63). `angles` [degrees] are those to the two other films.
[[nodiscard]] double end_length(const std::array<double, 2>& angles);

/// The same for both ends of every film, at its begin and at its end, by the angles of their junctions. Where more than
/// three films meet, or the junction is at a wall, that of 120 degrees is taken.
[[nodiscard]] std::vector<std::array<double, 2>> end_lengths(const FilmNetwork& network);

}  // namespace breccia::films
