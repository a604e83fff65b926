#include "results/film_field_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
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
#include "results/film_cuts.hpp"
#include "results/volume_quantities.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

double stress_of(Load load, const FilmCell<2>& cell) {
  return modulus_of<2>(load, {.xx = cell.stress[0], .yy = cell.stress[1], .xy = cell.stress[3]});
}
double stress_of(Load load, const FilmCell<3>& cell) {
  return stress_under(load, cell.stress);
}

double strain_of(Load load, const FilmCell<2>& cell) {
  return compliance_of<2>(load, {.xx = cell.strain[0], .yy = cell.strain[1], .xy = cell.strain[2]});
}
double strain_of(Load load, const FilmCell<3>& cell) {
  return strain_under(load, cell.strain);
}

/// The largest shear strain in the plane, the equivalent shear strain in space.
double shear_of(const FilmCell<2>& cell) {
  return std::hypot(cell.strain[0] - cell.strain[1], 2.0 * cell.strain[2]);
}
double shear_of(const FilmCell<3>& cell) {
  return equivalent_shear(cell.strain);
}

/// The mean over the box of a value of the cells.
template <int dim>
double mean_of(const FilmFields<dim>& fields, const std::function<double(const FilmCell<dim>&)>& of_cell) {
  double sum = 0.0, content = 0.0;
  for (const auto& cell : fields.cells) {
    sum += cell.content * of_cell(cell);
    content += cell.content;
  }
  return sum / content;
}

/// Components in the order of VTK: xx, yy, zz, xy, yz, xz.
using VtkTensor = std::array<double, 6>;

VtkTensor vtk_strain(const FilmCell<2>& cell) {
  return {cell.strain[0], cell.strain[1], 0.0, cell.strain[2], 0.0, 0.0};
}
VtkTensor vtk_stress(const FilmCell<2>& cell) {
  return {cell.stress[0], cell.stress[1], cell.stress[2], cell.stress[3], 0.0, 0.0};
}
VtkTensor vtk_strain(const FilmCell<3>& cell) {
  return in_order_of_vtk(cell.strain);
}
VtkTensor vtk_stress(const FilmCell<3>& cell) {
  return in_order_of_vtk(cell.stress);
}

template <int dim>
void write_file(const fs::path& path, const TimedFilmFields<dim>& timed) {
  const auto& [time, fields] = timed;
  PieceMesh<dim> mesh{.points = fields.points, .corners = {}, .corner_counts = {}};
  for (const auto corner : fields.corners) mesh.corners.push_back(static_cast<std::int64_t>(corner));
  std::vector<std::uint8_t> material, part;
  std::vector<float> displacement, strain, stress, work, slip, opening, flow;
  const auto append = [](std::vector<float>& values, std::span<const double> components) {
    for (const double component : components) values.push_back(static_cast<float>(component));
  };
  for (const auto& u : fields.displacement) append(displacement, std::array{u[0], u[1], dim == 3 ? u.back() : 0.0});
  for (const auto& cell : fields.cells) {
    mesh.corner_counts.push_back(static_cast<std::int64_t>(cell.corners));
    material.push_back(cell.part == FilmPart::grain ? 1 : 0);
    part.push_back(static_cast<std::uint8_t>(cell.part));
    append(strain, vtk_strain(cell));
    append(stress, vtk_stress(cell));
    append(work, std::array{cell.work});
    append(slip, std::array{cell.slip});
    append(opening, std::array{cell.opening});
    append(flow, std::array{cell.flow});
  }
  write_vtkhdf(path, mesh,
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

/// A quantity that a map shows in each cell; a cell without a value is grey, a gap red.
template <int dim>
struct MapOfCells {
  std::function<std::optional<double>(const FilmCell<dim>&)> value_of;
  FieldQuantity quantity;
  ColourScale scale = ColourScale::linear;
};

/// The stress component of a load, relative to the applied strain or stress.
template <int dim>
MapOfCells<dim> stress_map(const FilmFields<dim>& fields, const TestId& test) {
  const auto load = test.load.of_test().value();
  const auto stress = [load](const FilmCell<dim>& cell) { return stress_of(load, cell); };
  const auto of_matter = [stress](const FilmCell<dim>& cell) {
    return cell.part == FilmPart::gap ? std::nullopt : std::optional(stress(cell));
  };
  const double mean = mean_of<dim>(fields, stress);
  return {of_matter,
          dim == 2 ? stress_quantity(test.boundary, load, mean) : stress_in_space(test.boundary, load, mean)};
}

/// The shear strain of each cell over the mean shear strain or dilatation of the load.
template <int dim>
MapOfCells<dim> strain_map(const FilmFields<dim>& fields, const TestId& test) {
  const auto load = test.load.of_test().value();
  const double mean = mean_of<dim>(fields, [load](const FilmCell<dim>& cell) { return strain_of(load, cell); });
  const auto of_matter = [](const FilmCell<dim>& cell) {
    return cell.part == FilmPart::gap ? std::nullopt : std::optional(shear_of(cell));
  };
  return {of_matter, dim == 2 ? strain_quantity(load, mean) : strain_in_space(load, mean), ColourScale::logarithmic};
}

/// The work in the binder over its mean in the box.
template <int dim>
MapOfCells<dim> work_map(const FilmFields<dim>& fields) {
  const auto in_binder = [](const FilmCell<dim>& cell) { return cell.part == FilmPart::grain ? 0.0 : cell.work; };
  const auto work = [](const FilmCell<dim>& cell) {
    const bool is_binder = cell.part != FilmPart::grain && cell.part != FilmPart::gap;
    return is_binder ? std::optional(cell.work) : std::nullopt;
  };
  constexpr double per_cent = 100.0;
  const double mean = mean_of<dim>(fields, &FilmCell<dim>::work);
  const bool has_springs =
      std::ranges::any_of(fields.cells, [](const auto& cell) { return cell.part == FilmPart::spring; });
  auto words = fmt::format("Work over its mean; {:.3g} % of all is in the binder{}",
                           per_cent * mean_of<dim>(fields, in_binder) / mean, has_springs ? " and its springs" : "");
  return {work, {.words = std::move(words), .unit_size = mean}, ColourScale::logarithmic};
}

template <int dim>
PolygonPicture picture_of(const FilmFields<dim>& fields, double side, const MapOfCells<dim>& map) {
  PolygonPicture picture{.quantity = map.quantity.words, .unit_size = map.quantity.unit_size, .scale = map.scale};
  for (auto& [cell, corners] : polygons_of(fields, side)) {
    const auto& of_cell = fields.cells[cell];
    picture.polygons.push_back({std::move(corners), map.value_of(of_cell), of_cell.part == FilmPart::gap});
  }
  picture.side = side;
  return picture;
}

/// The title of a map, which says where it is in a box in space, and that gaps are red.
template <int dim>
std::string title_of(const Stage& stage, const TestId& test, const TimedFilmFields<dim>& timed) {
  const auto is_gap = [](const FilmCell<dim>& cell) { return cell.part == FilmPart::gap; };
  const bool has_gaps = std::ranges::any_of(timed.fields.cells, is_gap);
  return fmt::format("{}{}{}", field_title(stage, test, timed.time), dim == 3 ? ", halfway up the box" : "",
                     has_gaps ? ", gaps red" : "");
}

}  // namespace

template <int dim>
std::vector<FieldRecord> write_fields(const fs::path& directory, const Study& study, const Stage& stage,
                                      const TestId& test, const NetworkFields<dim>& fields) {
  auto records = field_records(study, test, times_of(fields));
  parallel::done_by_first([&] {
    for (std::size_t i = 0; i < fields.at_times.size(); ++i) {
      const auto& cells = fields.at_times[i].fields;
      const auto& record = records[i];
      write_file(directory / record.file, fields.at_times[i]);
      const auto draw = [&](const std::string& file, const MapOfCells<dim>& map) {
        auto picture = picture_of(cells, stage.side, map);
        picture.title = title_of(stage, test, fields.at_times[i]);
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

template std::vector<FieldRecord> write_fields(const fs::path&, const Study&, const Stage&, const TestId&,
                                               const NetworkFields<2>&);
template std::vector<FieldRecord> write_fields(const fs::path&, const Study&, const Stage&, const TestId&,
                                               const NetworkFields<3>&);

}  // namespace breccia
