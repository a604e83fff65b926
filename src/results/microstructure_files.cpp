#include "results/microstructure_files.hpp"

#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "breccia/results/label_files.hpp"

#include "homogenisation/box/crystal_orientations.hpp"
#include "homogenisation/box/debonded_films.hpp"
#include "io/text_file.hpp"
#include "microstructure/tessellation/tessellation_statistics.hpp"
#include "results/crystal_files.hpp"
#include "results/particle_files.hpp"
#include "results/stage_picture.hpp"
#include "tables/csv.hpp"

namespace breccia {
namespace {

constexpr std::array coordinate_names = {"x_m", "y_m", "z_m"};

template <int dim>
void write_grains(const std::filesystem::path& directory, const Stage& stage, const Tessellation<dim>& tessellation,
                  double film) {
  std::vector<std::vector<double>> coordinates(static_cast<std::size_t>(dim));
  std::vector<double> weights, cells, sizes, diameters, aspect_ratios, neighbours;
  for (const auto& [position, weight] : tessellation.sites().sites) {
    for (std::size_t axis = 0; axis < position.size(); ++axis) coordinates[axis].push_back(position[axis]);
    weights.push_back(weight);
  }
  for (const auto& grain : grain_geometries(tessellation, film)) {
    cells.push_back(grain.cell_volume);
    sizes.push_back(grain.grain_volume);
    diameters.push_back(grain.diameter);
    aspect_ratios.push_back(grain.aspect_ratio);
    neighbours.push_back(static_cast<double>(grain.neighbours));
  }
  std::vector<CsvColumn> columns;
  for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
    columns.push_back({coordinate_names[axis], coordinates[axis]});
  }
  columns.push_back({"weight_m2", weights});
  columns.push_back({dim == 3 ? "cell_volume_m3" : "cell_area_m2", cells});
  columns.push_back({dim == 3 ? "grain_volume_m3" : "grain_area_m2", sizes});
  columns.push_back({"equivalent_diameter_m", diameters});
  columns.push_back({"aspect_ratio", aspect_ratios});
  columns.push_back({"neighbours", neighbours});
  if (const auto angles = crystal_orientations(stage, 0, weights.size()); !angles.empty()) {
    for (auto& column : columns_of_angles(angles)) columns.push_back(std::move(column));
  }
  const auto& film_shares = tessellation.sites().film_shares;
  if (!film_shares.empty()) columns.push_back({"film_share", film_shares});
  write_csv(directory / "grains.csv", columns,
            fmt::format("Grains of stage {} in a box of {} m, with films of {} m between them", stage.name, stage.side,
                        film));
}

/// Writes all films, by the rows of their grains in grains.csv, and which of them are debonded.
template <int dim>
void write_films(const std::filesystem::path& directory, const Stage& stage, const Tessellation<dim>& tessellation) {
  if (!stage.bonds) return;
  constexpr std::array image_names = {"image_x", "image_y", "image_z"};
  constexpr std::array normal_names = {"normal_x", "normal_y", "normal_z"};
  const auto chosen = debonded_films(stage, tessellation).faces;
  const std::set<CellFace<dim>> debonded(chosen.begin(), chosen.end());
  std::vector<double> first, second, areas, are_debonded;
  std::vector<std::vector<double>> images(static_cast<std::size_t>(dim)), normals(images.size());
  for (const auto& [face, normal, area] : measured_faces(tessellation)) {
    first.push_back(static_cast<double>(face.first));
    second.push_back(static_cast<double>(face.second));
    for (std::size_t axis = 0; axis < images.size(); ++axis) {
      images[axis].push_back(face.image[axis]);
      normals[axis].push_back(normal[axis]);
    }
    areas.push_back(area);
    are_debonded.push_back(debonded.contains(face) ? 1.0 : 0.0);
  }
  std::vector<CsvColumn> columns = {{"first_grain", first}, {"second_grain", second}};
  for (std::size_t axis = 0; axis < images.size(); ++axis) columns.push_back({image_names[axis], images[axis]});
  for (std::size_t axis = 0; axis < images.size(); ++axis) columns.push_back({normal_names[axis], normals[axis]});
  columns.push_back({dim == 3 ? "area_m2" : "length_m", areas});
  columns.push_back({"debonded", are_debonded});
  write_csv(
      directory / "films.csv", columns,
      fmt::format("Films of stage {} between two grains, numbered from 0 as in grains.csv, the second displaced by "
                  "an image in sides of the box; bonds of the kind {} where debonded is 1",
                  stage.name, name_of(stage.bonds->kind)));
}

template <int dim>
void write_balls(const std::filesystem::path& directory, const Stage& stage, const Microstructure<dim>& box) {
  std::vector<std::vector<double>> coordinates(static_cast<std::size_t>(dim));
  std::vector<double> diameters;
  for (const auto& [centre, diameter] : box.particles) {
    for (std::size_t axis = 0; axis < centre.size(); ++axis) coordinates[axis].push_back(centre[axis]);
    diameters.push_back(diameter);
  }
  std::vector<CsvColumn> columns;
  for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
    columns.push_back({coordinate_names[axis], coordinates[axis]});
  }
  columns.push_back({"diameter_m", diameters});
  const std::vector<double> fillers(box.fillers.begin(), box.fillers.end());
  if (!fillers.empty()) columns.push_back({"filler", fillers});
  write_csv(directory / "microstructure.csv", columns,
            fmt::format("Particles of stage {} in a box of {} m", stage.name, stage.side));
}

/// Writes the particles or grains of a box; an image has neither.
struct WriteTable {
  const std::filesystem::path& directory;
  const Stage& stage;

  template <int dim>
  void operator()(const Microstructure<dim>& balls) const {
    write_balls(directory, stage, balls);
  }
  void operator()(const ParticleBox& particles) const { write_particles(directory, stage, particles); }
  void operator()(const EllipsoidBox& ellipsoids) const { write_ellipsoids(directory, stage, ellipsoids); }
  template <int dim>
  void operator()(const Grains<dim>& grains) const {
    const Tessellation<dim> tessellation(grains.sites);
    write_grains(directory, stage, tessellation, grains.statistics.film);
    write_films(directory, stage, tessellation);
  }
  template <int dim>
  void operator()(const SharedImage<dim>&) const {}
};

}  // namespace

void write_microstructure(const std::filesystem::path& directory, const Stage& stage,
                          const StageMicrostructure& microstructure) {
  write_labels(directory, stage, microstructure);
  visit_nested(WriteTable{directory, stage}, microstructure.box);
  write_crystals(directory, stage, microstructure);
  write_text(directory / "microstructure.svg", stage_picture(stage, microstructure));
  if (stage.dimensions() == 2) return;
  write_text(directory / "cut-x.svg", stage_picture(stage, microstructure, Axis::x));
  write_text(directory / "cut-y.svg", stage_picture(stage, microstructure, Axis::y));
}

}  // namespace breccia
