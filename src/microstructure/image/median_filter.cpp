#include "microstructure/image/median_filter.hpp"

#include <algorithm>

namespace breccia {

namespace {

/// The places along an axis from `radius` before one to `radius` behind it, the nearest ones within the axis.
std::vector<std::size_t> places_around(std::size_t place, std::size_t extent, int radius) {
  std::vector<std::size_t> places;
  for (int step = -radius; step <= radius; ++step) {
    const auto at = static_cast<std::ptrdiff_t>(place) + step;
    places.push_back(
        static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, static_cast<std::ptrdiff_t>(extent) - 1)));
  }
  return places;
}

}  // namespace

std::vector<std::int32_t> median_filtered(std::span<const std::int32_t> values,
                                          const std::array<std::size_t, 3>& extents, int side) {
  const auto [columns, rows, layers] = extents;
  const int radius = side / 2;
  const int across_layers = layers > 1 ? radius : 0;
  std::vector<std::vector<std::size_t>> around_column;
  for (std::size_t column = 0; column < columns; ++column) {
    around_column.push_back(places_around(column, columns, radius));
  }
  std::vector<std::int32_t> filtered, window;
  filtered.reserve(values.size());
  for (std::size_t layer = 0; layer < layers; ++layer) {
    const auto near_layers = places_around(layer, layers, across_layers);
    for (std::size_t row = 0; row < rows; ++row) {
      const auto near_rows = places_around(row, rows, radius);
      for (const auto& near_columns : around_column) {
        window.clear();
        for (const auto z : near_layers) {
          for (const auto y : near_rows) {
            const auto line = values.subspan((z * rows + y) * columns, columns);
            for (const auto x : near_columns) window.push_back(line[x]);
          }
        }
        const auto middle = window.begin() + static_cast<std::ptrdiff_t>(window.size() / 2);
        std::ranges::nth_element(window, middle);
        filtered.push_back(*middle);
      }
    }
  }
  return filtered;
}

}  // namespace breccia
