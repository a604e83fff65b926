#include "results/film_field_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/discretisation/load.hpp"

#include "io/text_file.hpp"
#include "parallel/common_failure.hpp"
#include "rasters/vtkhdf.hpp"
#include "report/polygon_picture.hpp"
#include "results/field_files.hpp"
#include "results/field_quantities.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

Stress<2> in_plane_stress(const FilmCell& cell) {
  return {.xx = cell.stress[0], .yy = cell.stress[1], .xy = cell.stress[3]};
}

Strain<2> in_plane_strain(const FilmCell& cell) {
  return {.xx = cell.strain[0], .yy = cell.strain[1], .xy = cell.strain[2]};
}

/// The mean over the box of a value of the cells.
double mean_of(const FilmFields& fields, const std::function<double(const FilmCell&)>& of_cell) {
  double sum = 0.0, area = 0.0;
  for (const auto& cell : fields.cells) {
    sum += cell.area * of_cell(cell);
    area += cell.area;
  }
  return sum / area;
}

void write_vtkhdf(const fs::path& path, const TimedFilmFields& timed) {
  const auto& [time, fields] = timed;
  PolygonMesh mesh;
  for (const auto& [x, y] : fields.points) mesh.points.push_back({x, y});
  for (const auto corner : fields.corners) mesh.corners.push_back(static_cast<std::int64_t>(corner));
  std::vector<std::uint8_t> material, part;
  std::vector<float> displacement, strain, stress, work, slip, opening, flow;
  const auto append = [](std::vector<float>& values, std::initializer_list<double> components) {
    for (const double component : components) values.push_back(static_cast<float>(component));
  };
  for (const auto& u : fields.displacement) append(displacement, {u[0], u[1], 0.0});
  for (const auto& cell : fields.cells) {
    mesh.corner_counts.push_back(static_cast<std::int64_t>(cell.corners));
    material.push_back(cell.part == FilmPart::grain ? 1 : 0);
    part.push_back(static_cast<std::uint8_t>(cell.part));
    const auto& e = cell.strain;
    const auto& s = cell.stress;
    append(strain, {e[0], e[1], 0.0, e[2], 0.0, 0.0});
    append(stress, {s[0], s[1], s[2], s[3], 0.0, 0.0});
    append(work, {cell.work});
    append(slip, {cell.slip});
    append(opening, {cell.opening});
    append(flow, {cell.flow});
  }
  breccia::write_vtkhdf(path, mesh,
                        {{"material", 1, std::move(material)},
                         {"part", 1, std::move(part)},
                         {"strain", 6, std::move(strain)},
                         {"stress_Pa", 6, std::move(stress)},
                         {"work_Pa", 1, std::move(work)},
                         {"slip_m", 1, std::move(slip)},
                         {"opening_m", 1, std::move(opening)},
                         {"flow_m", 1, std::move(flow)}},
                        {{"displacement_m", 3, std::move(displacement)}}, {{"time_s", time}});
}

/// The value that a map shows in each cell; a cell without a value is grey.
struct MapOfCells {
  std::function<std::optional<double>(const FilmCell&)> value_of;
  FieldQuantity quantity;
  ColourScale scale = ColourScale::linear;
};

/// The stress component of a load, relative to the applied strain or stress.
MapOfCells stress_map(const FilmFields& fields, const TestId& test) {
  const auto load = test.load.of_test().value();
  const auto stress = [load](const FilmCell& cell) { return modulus_of<2>(load, in_plane_stress(cell)); };
  const auto of_matter = [stress](const FilmCell& cell) {
    return cell.part == FilmPart::gap ? std::nullopt : std::optional(stress(cell));
  };
  return {of_matter, stress_quantity(test.boundary, load, mean_of(fields, stress))};
}

/// The largest shear strain of each cell over the mean shear strain or dilatation of the load.
MapOfCells strain_map(const FilmFields& fields, const TestId& test) {
  const auto load = test.load.of_test().value();
  const auto strain = [load](const FilmCell& cell) { return compliance_of<2>(load, in_plane_strain(cell)); };
  const auto largest_shear = [](const FilmCell& cell) {
    return std::hypot(cell.strain[0] - cell.strain[1], 2.0 * cell.strain[2]);
  };
  return {largest_shear, strain_quantity(load, mean_of(fields, strain)), ColourScale::logarithmic};
}

/// The work in films and junctions over its mean in the box.
MapOfCells work_map(const FilmFields& fields) {
  const double mean = mean_of(fields, &FilmCell::work);
  const auto in_binder = [](const FilmCell& cell) { return cell.part == FilmPart::grain ? 0.0 : cell.work; };
  const auto work = [](const FilmCell& cell) {
    const bool is_binder = cell.part == FilmPart::film || cell.part == FilmPart::junction;
    return is_binder ? std::optional(cell.work) : std::nullopt;
  };
  constexpr double per_cent = 100.0;
  auto words =
      fmt::format("Work over its mean; {:.3g} % of all is in the binder", per_cent * mean_of(fields, in_binder) / mean);
  return {work, {.words = std::move(words), .unit_size = mean}, ColourScale::logarithmic};
}

PolygonPicture picture_of(const FilmFields& fields, const MapOfCells& map) {
  PolygonPicture picture{.quantity = map.quantity.words, .unit_size = map.quantity.unit_size, .scale = map.scale};
  auto corner = fields.corners.begin();
  for (const auto& cell : fields.cells) {
    auto& polygon = picture.polygons.emplace_back(MapPolygon{.corners = {}, .value = map.value_of(cell)});
    for (std::size_t i = 0; i < cell.corners; ++i, ++corner) polygon.corners.push_back(fields.points[*corner]);
  }
  return picture;
}

}  // namespace

std::vector<FieldRecord> write_fields(const fs::path& directory, const Study& study, const Stage& stage,
                                      const TestId& test, const NetworkFields& fields) {
  auto records = field_records(study, test, times_of(fields));
  parallel::done_by_first([&] {
    for (std::size_t i = 0; i < fields.at_times.size(); ++i) {
      const auto& cells = fields.at_times[i].fields;
      const auto& record = records[i];
      write_vtkhdf(directory / record.file, fields.at_times[i]);
      const auto draw = [&](const std::string& file, const MapOfCells& map) {
        auto picture = picture_of(cells, map);
        picture.title = field_title(stage, test, fields.at_times[i].time);
        picture.side = stage.side;
        picture.load = drawn_load(test.load.of_test().value());
        picture.is_periodic = test.boundary == Boundary::periodic;
        write_text(directory / file, polygon_picture(picture));
      };
      draw(record.stress_picture, stress_map(cells, test));
      draw(record.strain_picture, strain_map(cells, test));
      draw(record.work_picture, work_map(cells));
    }
  });
  return records;
}

}  // namespace breccia
