#include "deck/listed_particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "io/units.hpp"

namespace breccia {
namespace {

/// Adds a centre outside the box to the mistakes.
template <std::size_t dim>
void check_centre(const std::array<double, dim>& centre, double side, const std::string& place,
                  FileMistakes& mistakes) {
  const auto is_outside = [side](double x) { return x < 0.0 || x > side; };
  if (std::ranges::none_of(centre, is_outside)) return;
  std::vector<std::string> coordinates;
  coordinates.reserve(dim);
  for (const double x : centre) coordinates.push_back(readable(x, Dimension::length));
  mistakes.add(place, fmt::format("expected a centre in the box, 0 to {}", readable(side, Dimension::length)),
               fmt::format("({})", fmt::join(coordinates, ", ")));
}

}  // namespace

bool lists_ellipses(const MeasuredTable& table) {
  return table.has({Quantity::axis_1}) || table.has({Quantity::axis_2}) || table.has({Quantity::angle});
}

std::vector<Particle> read_ellipses(const MeasuredTable& table, double side, FileMistakes& mistakes) {
  if (table.has({Quantity::diameter})) {
    throw InputError(
        fmt::format("{}: expected either diameters, or axis_1, axis_2 and angle, but it has columns of both",
                    table.path().string()));
  }
  table.require({Quantity::x, Quantity::y, Quantity::axis_1, Quantity::axis_2, Quantity::angle});
  const auto& x = table.column(Quantity::x).values;
  const auto& y = table.column(Quantity::y).values;
  const auto& first = table.column(Quantity::axis_1);
  const auto& second = table.column(Quantity::axis_2);
  const auto& angles = table.column(Quantity::angle);
  const auto is_length = [](double length) { return length > 0.0 && std::isfinite(length); };
  std::vector<Particle> particles;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Vector<2> axes = {first.values[row], second.values[row]}, centre = {x[row], y[row]};
    if (!std::ranges::all_of(axes, is_length)) {
      mistakes.add(table.location(row), "expected positive axes",
                   fmt::format("{} and {}", first.written[row], second.written[row]));
    } else if (!std::isfinite(angles.values[row])) {
      mistakes.add(table.location(row), "expected a finite angle", fmt::format("{}", angles.written[row]));
    } else {
      check_centre(centre, side, table.location(row), mistakes);
    }
    particles.push_back({Ellipse{axes}, Pose(centre, angles.values[row])});
  }
  if (particles.empty()) mistakes.add("", "expected at least one ellipse");
  return particles;
}

bool lists_ellipsoids(const MeasuredTable& table) {
  constexpr std::array quantities = {Quantity::axis_1,  Quantity::axis_2,    Quantity::axis_3,
                                     Quantity::azimuth, Quantity::elevation, Quantity::roll};
  return std::ranges::any_of(quantities, [&table](Quantity quantity) { return table.has({quantity}); });
}

std::vector<Ellipsoid> read_ellipsoids(const MeasuredTable& table, double side, FileMistakes& mistakes) {
  if (table.has({Quantity::diameter})) {
    throw InputError(
        fmt::format("{}: expected either diameters, or axis_1, axis_2, axis_3, azimuth, elevation and roll, but it has "
                    "columns of both",
                    table.path().string()));
  }
  table.require({Quantity::x, Quantity::y, Quantity::z, Quantity::axis_1, Quantity::axis_2, Quantity::axis_3,
                 Quantity::azimuth, Quantity::elevation, Quantity::roll});
  const auto values = [&table](Quantity quantity, std::size_t row) { return table.column(quantity).values[row]; };
  const auto written = [&table](Quantity quantity, std::size_t row) { return table.column(quantity).written[row]; };
  const auto is_length = [](double length) { return length > 0.0 && std::isfinite(length); };
  std::vector<Ellipsoid> ellipsoids;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Vector<3> centre = {values(Quantity::x, row), values(Quantity::y, row), values(Quantity::z, row)};
    const Vector<3> axes = {values(Quantity::axis_1, row), values(Quantity::axis_2, row),
                            values(Quantity::axis_3, row)};
    const Turn turn = {values(Quantity::azimuth, row), values(Quantity::elevation, row), values(Quantity::roll, row)};
    if (!std::ranges::all_of(axes, is_length)) {
      mistakes.add(table.location(row), "expected positive axes",
                   fmt::format("{}, {} and {}", written(Quantity::axis_1, row), written(Quantity::axis_2, row),
                               written(Quantity::axis_3, row)));
    } else if (!std::isfinite(turn.azimuth + turn.elevation + turn.roll)) {
      mistakes.add(table.location(row), "expected finite angles",
                   fmt::format("{}, {} and {}", written(Quantity::azimuth, row), written(Quantity::elevation, row),
                               written(Quantity::roll, row)));
    } else {
      check_centre(centre, side, table.location(row), mistakes);
    }
    ellipsoids.push_back({centre, axes, turned(turn)});
  }
  if (ellipsoids.empty()) mistakes.add("", "expected at least one ellipsoid");
  return ellipsoids;
}

ListedPolygons read_polygons(const std::filesystem::path& file, double side, std::size_t fillers) {
  const auto table = read_measured_table(file);
  table.require({Quantity::particle, Quantity::x, Quantity::y});
  FileMistakes mistakes(file);
  const auto& numbers = table.column(Quantity::particle).values;
  const auto& x = table.column(Quantity::x).values;
  const auto& y = table.column(Quantity::y).values;
  const auto filler_of_row = read_filler_numbers(table, fillers, mistakes);
  std::map<double, std::vector<std::size_t>> rows_of;  // rows of the corners of each particle
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool goes_on = row > 0 && numbers[row] == numbers[row - 1];
    if (numbers[row] != std::floor(numbers[row])) {
      mistakes.add(table.location(row), fmt::format("expected the whole number of a particle, got {}", numbers[row]));
    } else if (!goes_on && rows_of.contains(numbers[row])) {
      mistakes.add(table.location(row), fmt::format("particle {}: expected its corners in one piece", numbers[row]));
    }
    rows_of[numbers[row]].push_back(row);
  }
  ListedPolygons polygons;
  for (const auto& [number, rows] : rows_of) {
    std::vector<Vector<2>> corners;
    for (const auto row : rows) corners.push_back({x[row], y[row]});
    const auto of_corners = corner_mistakes(corners);
    for (const auto& [corner, text] : of_corners) {
      mistakes.add(table.location(rows[corner]), fmt::format("particle {}: {}", number, text));
    }
    if (!filler_of_row.empty()) {
      const auto filler = filler_of_row[rows.front()];
      const auto differs = [&](std::size_t row) { return filler_of_row[row] != filler; };
      const auto other = std::ranges::find_if(rows, differs);
      if (other != rows.end()) {
        mistakes.add(table.location(*other), fmt::format("particle {}: expected one filler for all corners", number));
      }
      polygons.fillers.push_back(filler);
    }
    if (!of_corners.empty()) continue;
    const auto centre = centroid(corners);
    check_centre(centre, side, table.location(rows.front()), mistakes);
    polygons.particles.push_back({ConvexPolygon(corners), Pose(centre, 0.0)});
  }
  if (rows_of.empty()) mistakes.add("", "expected at least one polygon");
  mistakes.refuse();
  return polygons;
}

std::vector<std::size_t> read_filler_numbers(const MeasuredTable& table, std::size_t fillers, FileMistakes& mistakes) {
  if (!table.has({Quantity::filler})) {
    if (fillers > 1) mistakes.add("", "expected a column called filler with the number of the filler of each particle");
    return {};
  }
  const auto& column = table.column(Quantity::filler);
  std::vector<std::size_t> numbers;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double number = column.values[row];
    const bool is_filler = number >= 0.0 && number < static_cast<double>(fillers) && number == std::floor(number);
    if (!is_filler) {
      mistakes.add(table.location(row), fmt::format("expected the number of a filler, 0 to {}", fillers - 1),
                   fmt::format("{}", column.written[row]));
    }
    numbers.push_back(is_filler ? static_cast<std::size_t>(number) : 0);
  }
  return fillers > 1 ? numbers : std::vector<std::size_t>();
}

}  // namespace breccia
