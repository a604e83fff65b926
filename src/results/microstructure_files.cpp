#include "breccia/results/microstructure_files.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "breccia/homogenisation/middle_plane.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"
#include "breccia/io/csv.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/microstructure/tessellation_statistics.hpp"
#include "breccia/report/grain_picture.hpp"
#include "breccia/report/image_picture.hpp"
#include "breccia/report/microstructure_picture.hpp"
#include "breccia/report/particle_picture.hpp"
#include "breccia/results/label_files.hpp"

#include "particle_files.hpp"

namespace breccia {
namespace {

/// The fillers of a stage in the colours of their phases.
std::vector<DrawnFiller> drawn_fillers(const Stage& stage) {
  const auto phases = phases_of(stage);
  std::vector<DrawnFiller> drawn;
  for (const auto& filler : stage.fillers) {
    auto& one = drawn.emplace_back(DrawnFiller{phases.index_of(phase_of(stage, filler.material))});
    if (!filler.coating) continue;
    one.coating_colour = phases.index_of(phase_of(stage, filler.coating->material));
    one.coating_thickness = filler.coating->thickness;
  }
  return drawn;
}

/// The middle planes of a box of three dimensions; the one seen along z stands for the microstructure.
template <class Draw>
void write_cuts(const std::filesystem::path& directory, const Draw& draw) {
  write_text(directory / "microstructure.svg", draw(Axis::z));
  write_text(directory / "cut-x.svg", draw(Axis::x));
  write_text(directory / "cut-y.svg", draw(Axis::y));
}

/// The same of what is at the places of the planes, in the colours of the phases. `content` is what they cut through.
void write_planes(const std::filesystem::path& directory, const Stage& stage, const StageMicrostructure& packed,
                  std::string_view content) {
  write_cuts(directory, [&](Axis normal) {
    constexpr std::array names = {"x", "y", "z"};
    const auto axis = static_cast<std::size_t>(normal);
    return plane_picture(middle_plane(stage, packed, axis),
                         fmt::format("cut through the middle of {}, seen along {}", content, names[axis]));
  });
}

constexpr std::array coordinate_names = {"x_m", "y_m", "z_m"};

template <int dim>
void write_grain_table(const std::filesystem::path& directory, const Stage& stage,
                       const Tessellation<dim>& tessellation, double film) {
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
  const auto& film_shares = tessellation.sites().film_shares;
  if (!film_shares.empty()) columns.push_back({"film_share", film_shares});
  write_csv(directory / "grains.csv", columns,
            fmt::format("Grains of stage {} in a box of {} m, with films of {} m between them", stage.name, stage.side,
                        film));
}

void write_grains(const std::filesystem::path& directory, const Stage& stage, const StageMicrostructure& packed) {
  const auto& grains = *packed.grains;
  if (grains.sites_in_space) {
    write_grain_table(directory, stage, Tessellation<3>(*grains.sites_in_space), grains.film);
    write_planes(directory, stage, packed, fmt::format("{} grains", grains.cell_count()));
    return;
  }
  const Tessellation<2> tessellation(grains.sites);
  write_grain_table(directory, stage, tessellation, grains.film);
  write_text(directory / "microstructure.svg", grain_picture(tessellation, grains.film));
}

void write_image(const std::filesystem::path& directory, const Stage& stage, const LabelImage<2>& image) {
  const auto phases = phases_of(stage);
  std::vector<std::size_t> colours = {0};
  for (const auto& filler : stage.fillers) colours.push_back(phases.index_of(phase_of(stage, filler.material)));
  write_text(directory / "microstructure.svg", image_picture(image, colours));
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

}  // namespace

void write_microstructure(const std::filesystem::path& directory, const Stage& stage,
                          const StageMicrostructure& microstructure) {
  write_labels(directory, stage, microstructure);
  if (const auto* image = stage.image()) {
    write_image(directory, stage, *image);
    return;
  }
  if (const auto* stack = stage.stack()) {
    write_planes(directory, stage, microstructure, fmt::format("{} voxels", fmt::join(stack->pixels, " x ")));
    return;
  }
  if (microstructure.grains) {
    write_grains(directory, stage, microstructure);
    return;
  }
  if (microstructure.shaped) {
    write_particles(directory, stage, *microstructure.shaped);
    write_text(directory / "microstructure.svg", particle_picture(*microstructure.shaped, drawn_fillers(stage)));
    return;
  }
  if (microstructure.ellipsoids) {
    write_ellipsoids(directory, stage, *microstructure.ellipsoids);
    write_planes(directory, stage, microstructure,
                 fmt::format("{} particles", microstructure.ellipsoids->particles.size()));
    return;
  }
  if (microstructure.spheres) {
    write_balls(directory, stage, *microstructure.spheres);
    const auto fillers = drawn_fillers(stage);
    write_cuts(directory, [&](Axis normal) { return cut_picture(*microstructure.spheres, normal, fillers); });
    return;
  }
  write_balls(directory, stage, microstructure.microstructure);
  write_text(directory / "microstructure.svg",
             microstructure_picture(microstructure.microstructure, drawn_fillers(stage)));
}

}  // namespace breccia
