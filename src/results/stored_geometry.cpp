#include "results/stored_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "breccia/error.hpp"
#include "breccia/study/film_bonds.hpp"

#include "io/nearest_name.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

constexpr std::array coordinate_names = {"x_m", "y_m", "z_m"};

template <int dim>
Vector<dim> position_in(const CsvTable& table, std::size_t row) {
  Vector<dim> position{};
  for (std::size_t axis = 0; axis < position.size(); ++axis) {
    position[axis] = table.numbers(coordinate_names[axis])[row];
  }
  return position;
}

/// A whole number of a table. Throws FileError where it is none from `least` to `most`.
long whole_number(const CsvTable& table, const std::string& column, std::size_t row, long least, long most) {
  const double number = table.numbers(column)[row];
  if (number >= static_cast<double>(least) && number <= static_cast<double>(most) && number == std::floor(number)) {
    return static_cast<long>(number);
  }
  throw FileError(fmt::format("{}: {}: expected a whole number from {} to {}, got {:g}", table.location(row), column,
                              least, most, number));
}

/// Throws FileError where a table has not a row for each particle of the stage.
void require_all_particles(const CsvTable& table, const fs::path& file, const StageEntry& stage) {
  const auto expected = stage.microstructure.particles.value_or(table.rows());
  if (table.rows() == expected) return;
  throw FileError(fmt::format("{}: {} rows, where study.json has {} particles", file.string(), table.rows(), expected));
}

Ellipsoid ellipsoid_in(const CsvTable& table, std::size_t row) {
  Ellipsoid ellipsoid{.centre = position_in<3>(table, row)};
  if (table.has("diameter_m")) {
    ellipsoid.axes.fill(table.numbers("diameter_m")[row]);
    return ellipsoid;
  }
  constexpr double degree = std::numbers::pi / 180.0;
  constexpr std::array axis_names = {"axis_1_m", "axis_2_m", "axis_3_m"};
  for (std::size_t k = 0; k < axis_names.size(); ++k) ellipsoid.axes[k] = table.numbers(axis_names[k])[row];
  ellipsoid.directions =
      turned(Turn{degree * table.numbers("azimuth_deg")[row], degree * table.numbers("elevation_deg")[row],
                  degree * table.numbers("roll_deg")[row]});
  return ellipsoid;
}

}  // namespace

const StageEntry& stage_named(const StudyDocument& document, const std::string& name) {
  if (document.stages.empty()) throw InputError("no stage is packed yet");
  if (name.empty()) return document.stages.back();
  const auto found = std::ranges::find(document.stages, name, &StageEntry::name);
  if (found != document.stages.end()) return *found;
  std::vector<std::string> names;
  for (const auto& stage : document.stages) names.push_back(stage.name);
  throw InputError(fmt::format("no stage \"{}\"{}", name, suggestion(name, names)));
}

StoredEllipsoids read_stored_ellipsoids(const fs::path& directory, const StageEntry& stage) {
  const auto file = directory / "microstructure.csv";
  const auto table = read_csv(file);
  require_all_particles(table, file, stage);
  const auto last_filler = static_cast<long>(stage.fillers.size()) - 1;
  StoredEllipsoids stored;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    stored.particles.push_back(ellipsoid_in(table, row));
    const auto is_positive = [](double axis) { return axis > 0.0 && std::isfinite(axis); };
    if (!std::ranges::all_of(stored.particles.back().axes, is_positive)) {
      throw FileError(fmt::format("{}: expected positive diameters", table.location(row)));
    }
    const long filler = table.has("filler") ? whole_number(table, "filler", row, 0, last_filler) : 0;
    stored.fillers.push_back(static_cast<std::size_t>(filler));
  }
  return stored;
}

template <int dim>
LaguerreSites<dim> read_stored_sites(const fs::path& directory, const StageEntry& stage) {
  const auto& sides = stage.microstructure.sides;
  if (!sides) {
    throw InputError(
        fmt::format("{}: study.json does not say what is at the sides of the box, as that of an earlier "
                    "version: pack the study again",
                    stage.name));
  }
  LaguerreSites<dim> sites{.side = stage.side,
                           .walls = *sides == BoxSides::periodic ? Walls::periodic : Walls::hard,
                           .sites = {},
                           .wall_film = *sides == BoxSides::cut ? WallFilm::none : WallFilm::half};
  const auto file = directory / "grains.csv";
  const auto table = read_csv(file);
  require_all_particles(table, file, stage);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    sites.sites.push_back({position_in<dim>(table, row), table.numbers("weight_m2")[row]});
  }
  if (table.has("film_share")) sites.film_shares = table.numbers("film_share");
  return sites;
}

template LaguerreSites<2> read_stored_sites(const fs::path&, const StageEntry&);
template LaguerreSites<3> read_stored_sites(const fs::path&, const StageEntry&);

template <int dim>
DebondedFilms<dim> read_debonded_films(const fs::path& directory, const StageEntry& stage) {
  DebondedFilms<dim> debonded;
  const auto& entry = stage.microstructure.debonding;
  if (!entry) return debonded;
  const auto kind = value_named<Debonding>(entry->kind);
  if (!kind) throw InputError(fmt::format("{}: no kind of debonded films: {}", stage.name, entry->kind));
  debonded.kind = *kind;
  debonded.springs = {entry->normal_stiffness.value_or(0.0), entry->tangential_stiffness.value_or(0.0)};
  constexpr std::array image_names = {"image_x", "image_y", "image_z"};
  constexpr long farthest_image = 1;
  const long last_grain = static_cast<long>(stage.microstructure.particles.value_or(0)) - 1;
  const auto table = read_csv(directory / "films.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.numbers("debonded")[row] == 0.0) continue;
    const auto grain = [&](const char* column) {
      return static_cast<std::size_t>(whole_number(table, column, row, 0, last_grain));
    };
    CellFace<dim> face{.first = grain("first_grain"), .second = grain("second_grain")};
    for (std::size_t axis = 0; axis < face.image.size(); ++axis) {
      face.image[axis] = static_cast<int>(whole_number(table, image_names[axis], row, -farthest_image, farthest_image));
    }
    debonded.faces.push_back(face);
  }
  return debonded;
}

template DebondedFilms<2> read_debonded_films(const fs::path&, const StageEntry&);
template DebondedFilms<3> read_debonded_films(const fs::path&, const StageEntry&);

}  // namespace breccia
