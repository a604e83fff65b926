#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace breccia {

/// The sides between neighbouring squares of different phases as the data of an SVG path over the unit square, y
/// downwards. The phases are row by row from the lower left corner; where there are more than `most` columns, only
/// every second or third one, and so on, is used.
std::string outlines_of(const std::vector<std::uint8_t>& phases, std::size_t columns, std::size_t most);

}  // namespace breccia
