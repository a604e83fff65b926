#pragma once

#include <cstddef>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "breccia/study/test_id.hpp"

namespace breccia {

/// The data that the page draws from a file of fields of a test in a cube of this side [m]: `cells` along an axis;
/// `stress` and `strain` with the `words` of their legend, the `unit_size` of its labels, their `scale`, the values of
/// the lowest and the highest colour, `from` and `to`, and the colours of the cells, `values` (bytes_for_page);
/// `material` with the phases of the cells, of grains and films the number 2 where a film is debonded. Where there are
/// more than `most_along` cells along an axis, the values are means over blocks of cells; of grains and films they are
/// those at the middles of `most_along` cells along an axis. Throws FileError when the file cannot be read, or holds
/// neither grains and films nor the cells of a cube.
nlohmann::ordered_json field_view(const std::filesystem::path& file, double side, Load load, Boundary boundary,
                                  std::size_t most_along);

}  // namespace breccia
