#include "breccia/results/field_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "breccia/io/safe_name.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/io/vtkhdf.hpp"
#include "breccia/report/field_picture.hpp"

#include "field_quantities.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

void write_vtkhdf(const fs::path& path, const Grid<2>& grid, const TimedFields<2>& timed) {
  const auto& [time, fields] = timed;
  // Each material point is drawn as a quarter of a cell, so that integrals over the squares are those of the solver.
  const double spacing = 0.5 * grid.cell_side;
  const auto columns = 2 * static_cast<std::size_t>(grid.columns()), rows = 2 * static_cast<std::size_t>(grid.rows());
  std::vector<float> displacement, strain, stress;
  const auto append = [](std::vector<float>& values, std::initializer_list<double> components) {
    for (const double component : components) values.push_back(static_cast<float>(component));
  };
  for (const auto& u : fields.displacement) append(displacement, {u[0], u[1], 0.0});
  for (const auto& e : fields.strain) append(strain, {e[0], e[1], 0.0, e[2], 0.0, 0.0});
  for (const auto& s : fields.stress) append(stress, {s[0], s[1], s[2], s[3], 0.0, 0.0});
  // The phases of points are those of a stage, which are few: mixtures have been told apart by their largest part.
  std::vector<std::uint8_t> phases(fields.phase.begin(), fields.phase.end());
  breccia::write_vtkhdf(path, {columns, rows, {0.0, 0.0}, spacing},
                        {{"material", 1, std::move(phases)},
                         {"displacement_m", 3, std::move(displacement)},
                         {"strain", 6, std::move(strain)},
                         {"stress_Pa", 6, std::move(stress)}},
                        {{"time_s", time}});
}

/// The stress component of a load, relative to the applied strain or stress.
FieldPicture stress_map(const PointFields<2>& fields, Boundary boundary, Load load) {
  FieldPicture map;
  double sum = 0.0;
  for (const auto& s : fields.stress) {
    map.values.push_back(modulus_of<2>(load, {.xx = s[0], .yy = s[1], .xy = s[3]}));
    sum += map.values.back();
  }
  auto [words, unit_size] = stress_quantity(boundary, load, sum / static_cast<double>(fields.stress.size()));
  map.quantity = std::move(words);
  map.unit_size = unit_size;
  return map;
}

/// The largest shear strain at each point over the mean shear strain or dilatation of the load.
FieldPicture strain_map(const PointFields<2>& fields, Load load) {
  FieldPicture map{.scale = ColourScale::logarithmic};
  double sum = 0.0;
  for (const auto& [xx, yy, xy] : fields.strain) {
    map.values.push_back(std::hypot(xx - yy, 2.0 * xy));
    sum += compliance_of<2>(load, {.xx = xx, .yy = yy, .xy = xy});
  }
  auto [words, unit_size] = strain_quantity(load, sum / static_cast<double>(fields.strain.size()));
  map.quantity = std::move(words);
  map.unit_size = unit_size;
  return map;
}

/// Whether a name is this stem, alone or with a dash and a number.
bool is_numbered(std::string_view name, std::string_view stem) {
  if (!name.starts_with(stem)) return false;
  name.remove_prefix(stem.size());
  return name.empty() || (name.front() == '-' && is_count(name.substr(1)));
}

}  // namespace

std::vector<FieldRecord> field_records(const Study& study, const TestId& test, const std::vector<double>& times) {
  const auto& tests = study.tests;
  const bool is_first = test.boundary == tests.boundaries.front() && test.method == tests.methods.front();
  const auto name = is_first ? "fields" : fmt::format("fields-{}-{}", name_of(test.boundary), name_of(test.method));
  std::vector<FieldRecord> records;
  records.reserve(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto numbered = i + 1 == times.size() ? name : fmt::format("{}-{}", name, i + 1);
    records.push_back({.time = times[i],
                       .file = numbered + ".vtkhdf",
                       .stress_picture = numbered + "-stress.svg",
                       .strain_picture = numbered + "-strain.svg",
                       .work_picture = test.grid.is_films() ? numbered + "-work.svg" : ""});
  }
  return records;
}

std::vector<FieldRecord> write_fields(const fs::path& directory, const Study& study, const Stage& stage,
                                      const TestId& test, const Discretisation<2>& discretisation,
                                      const std::vector<TimedFields<2>>& fields) {
  std::vector<double> times;
  times.reserve(fields.size());
  for (const auto& [time, points] : fields) times.push_back(time);
  auto records = field_records(study, test, times);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto& [time, points] = fields[i];
    const auto& record = records[i];
    write_vtkhdf(directory / record.file, discretisation.grid(), fields[i]);
    const auto draw = [&, &points = fields[i].fields, title = field_title(stage, test, time)](const std::string& file,
                                                                                              FieldPicture picture) {
      picture.columns = 2 * static_cast<std::size_t>(discretisation.grid().columns());
      picture.title = title;
      picture.side = stage.side;
      picture.load = drawn_load(test.load);
      picture.phases.assign(points.phase.begin(), points.phase.end());
      write_text(directory / file, field_picture(picture));
    };
    draw(record.stress_picture, stress_map(points, test.boundary, test.load));
    draw(record.strain_picture, strain_map(points, test.load));
  }
  return records;
}

void copy_fields(const fs::path& from, const fs::path& to, const StageRecord& stage) {
  for (const auto& [test, files] : stage.fields) {
    for (const auto& record : files) {
      for (const auto& name : record.names()) copy_result(from / name, to / name);
    }
  }
}

bool is_of_fields(std::string_view name) {
  constexpr std::array<std::string_view, 4> endings = {".vtkhdf", "-stress.svg", "-strain.svg", "-work.svg"};
  const auto* const ending = std::ranges::find_if(endings, [&](auto one) { return name.ends_with(one); });
  if (ending == endings.end()) return false;
  name.remove_suffix(ending->size());
  if (is_numbered(name, "fields")) return true;
  for (const auto& [boundary, is_boundary] : words<Boundary>) {
    for (const auto& [method, is_method] : words<Method>) {
      if (is_numbered(name, fmt::format("fields-{}-{}", boundary, method))) return true;
    }
  }
  return false;
}

}  // namespace breccia
