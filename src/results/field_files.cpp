#include "results/field_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/safe_name.hpp"
#include "io/text_file.hpp"
#include "rasters/vtkhdf.hpp"
#include "report/field_picture.hpp"
#include "report/map_means.hpp"
#include "results/field_pieces.hpp"
#include "results/field_quantities.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// A map of the points, and the sum over them of the value that determines the unit of its labels.
struct PointMap {
  explicit PointMap(std::size_t columns) : means(columns, most_map_columns) {}

  MapMeans means;
  double sum = 0.0;
};

/// The file and the pictures of the fields of the points of a square, from their pieces.
class FieldsOfSquare {
 public:
  FieldsOfSquare(const fs::path& path, const Grid<2>& grid, double time, Load load)
      : load_(load),
        columns_(2 * static_cast<std::size_t>(grid.columns())),
        // Each material point is drawn as a quarter of a cell, so that integrals over the squares are those of the
        // solver.
        file_(path, PlaneLattice{columns_, 2 * static_cast<std::size_t>(grid.rows()), {0.0, 0.0}, 0.5 * grid.cell_side},
              {{"time_s", time}}),
        stress_(columns_),
        strain_(columns_) {
    file_.add_field<std::uint8_t>("material", 1);
    file_.add_field<float>("displacement_m", 3);
    file_.add_field<float>("strain", 6);
    file_.add_field<float>("stress_Pa", 6);
  }

  void take(std::size_t first, const PointFields<2>& piece) {
    write(first, piece);
    for (std::size_t i = 0; i < piece.phase.size(); ++i) {
      if (stress_.means.begins_square()) phases_.push_back(static_cast<std::uint8_t>(piece.phase[i]));
      const auto& s = piece.stress[i];
      const double stress = modulus_of<2>(load_, {.xx = s[0], .yy = s[1], .xy = s[3]});
      stress_.means.add(stress);
      stress_.sum += stress;
      const auto& [xx, yy, xy] = piece.strain[i];
      strain_.means.add(std::hypot(xx - yy, 2.0 * xy));
      strain_.sum += compliance_of<2>(load_, {.xx = xx, .yy = yy, .xy = xy});
    }
  }

  void commit() { file_.commit(); }

  /// The stress component of the load, relative to the applied strain or stress.
  [[nodiscard]] FieldPicture stress_picture(Boundary boundary) const {
    return picture_of(stress_, stress_quantity(boundary, load_, mean_of(stress_)), ColourScale::linear);
  }
  /// The largest shear strain at each point over the mean shear strain or dilatation of the load.
  [[nodiscard]] FieldPicture strain_picture() const {
    return picture_of(strain_, strain_quantity(load_, mean_of(strain_)), ColourScale::logarithmic);
  }

 private:
  void write(std::size_t first, const PointFields<2>& piece) {
    std::vector<float> displacement, strain, stress;
    const auto append = [](std::vector<float>& values, std::initializer_list<double> components) {
      for (const double component : components) values.push_back(static_cast<float>(component));
    };
    for (const auto& u : piece.displacement) append(displacement, {u[0], u[1], 0.0});
    for (const auto& e : piece.strain) append(strain, {e[0], e[1], 0.0, e[2], 0.0, 0.0});
    for (const auto& s : piece.stress) append(stress, {s[0], s[1], s[2], s[3], 0.0, 0.0});
    // The phases of points fit into a byte, because a stage has few: a mixture counts as its largest part.
    file_.write("material", first, std::vector<std::uint8_t>(piece.phase.begin(), piece.phase.end()));
    file_.write("displacement_m", first, displacement);
    file_.write("strain", first, strain);
    file_.write("stress_Pa", first, stress);
  }

  [[nodiscard]] double mean_of(const PointMap& map) const { return map.sum / static_cast<double>(columns_ * columns_); }

  [[nodiscard]] FieldPicture picture_of(const PointMap& map, FieldQuantity quantity, ColourScale scale) const {
    return {.quantity = std::move(quantity.words),
            .unit_size = quantity.unit_size,
            .columns = map.means.columns(),
            .values = map.means.values(),
            .scale = scale,
            .load = drawn_load(load_),
            .phases = phases_};
  }

  Load load_;
  std::size_t columns_;
  VtkhdfFile file_;
  PointMap stress_, strain_;
  std::vector<std::uint8_t> phases_;  ///< phases of the first point of each square of the maps
};

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
                                      const TestId& test, const GridFields<2>& fields) {
  auto records = field_records(study, test, times_of(fields));
  for (std::size_t i = 0; i < fields.at_times.size(); ++i) {
    const auto& [time, own] = fields.at_times[i];
    const auto& record = records[i];
    std::optional<FieldsOfSquare> all;
    const auto draw = [&, title = field_title(stage, test, time)](const std::string& file, FieldPicture picture) {
      picture.title = title;
      picture.side = stage.side;
      write_text(directory / file, field_picture(picture));
    };
    collect_fields(
        fields.grid, own,
        [&, time = time] { all.emplace(directory / record.file, fields.grid, time, test.load.of_test().value()); },
        [&](std::size_t first, const PointFields<2>& piece) { all->take(first, piece); },
        [&] {
          all->commit();
          draw(record.stress_picture, all->stress_picture(test.boundary));
          draw(record.strain_picture, all->strain_picture());
        });
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
