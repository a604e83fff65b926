#include "page/microstructure_view.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "breccia/rasters/raster_reader.hpp"

#include "page/page_bytes.hpp"
#include "page/report_data.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// More particles would take megabytes of a page, and could not be distinguished in it.
constexpr std::size_t most_drawn_particles = 200000;

/// The rows of the largest particles, in the order of the table.
std::vector<std::size_t> drawn_rows(const std::vector<double>& sizes) {
  std::vector<std::size_t> rows(sizes.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  if (rows.size() <= most_drawn_particles) return rows;
  std::ranges::stable_sort(rows, std::greater{}, [&](std::size_t row) { return sizes[row]; });
  rows.resize(most_drawn_particles);
  std::ranges::sort(rows);
  return rows;
}

Json particles_of(const CsvTable& table) {
  const auto rows = drawn_rows(table.numbers(table.has("diameter_m") ? "diameter_m" : "axis_1_m"));
  Json columns = Json::object();
  for (const auto& name : table.names()) {
    const auto& numbers = table.numbers(name);
    std::vector<double> drawn;
    drawn.reserve(rows.size());
    for (const auto row : rows) drawn.push_back(numbers[row]);
    columns[name] = numbers_for_page(drawn);
  }
  return {{"count", rows.size()}, {"listed", table.rows()}, {"columns", std::move(columns)}};
}

/// Every point of a raster, or every second or third one, and so on, so that a limited number remains along each axis.
Json phases_of(const Raster& raster) {
  constexpr std::size_t most_along = 128;
  const auto longest = std::ranges::max(raster.extents);
  const auto step = (longest + most_along - 1) / most_along;
  std::array<std::size_t, 3> along{};
  for (std::size_t axis = 0; axis < along.size(); ++axis) along[axis] = (raster.extents[axis] + step - 1) / step;
  std::vector<std::uint8_t> phases;
  for (std::size_t z = 0; z < raster.extents[2]; z += step) {
    for (std::size_t y = 0; y < raster.extents[1]; y += step) {
      for (std::size_t x = 0; x < raster.extents[0]; x += step) {
        const auto point = (z * raster.extents[1] + y) * raster.extents[0] + x;
        phases.push_back(static_cast<std::uint8_t>(raster.values[point]));
      }
    }
  }
  return {{"cells", along}, {"values", bytes_for_page(phases)}};
}

}  // namespace

Json microstructure_view(const fs::path& directory) {
  if (const auto listed = directory / "microstructure.csv"; is_there(listed)) {
    const auto table = read_csv(listed);
    if (table.has("z_m")) return {{"particles", particles_of(table)}};
  }
  if (const auto labels = directory / "labels.npy"; is_there(labels)) {
    const auto raster = read_raster(labels);
    if (raster.extents.size() == 3) return {{"phases", phases_of(raster)}};
  }
  return {};
}

}  // namespace breccia
