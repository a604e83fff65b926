#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace breccia {

/// The sides between neighbouring squares of different phases as the data of an SVG path over the unit square, y
/// downwards. The phases stand row by row from the lower left corner; of more than `most` columns every second one
/// counts, every third one and so on.
std::string outlines_of(const std::vector<std::uint8_t>& phases, std::size_t columns, std::size_t most);

}  // namespace breccia
