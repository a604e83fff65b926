#include "breccia/results/microstructure_files.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

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

void write_grains(const std::filesystem::path& directory, const Stage& stage, const StageGrains& grains) {
  const Tessellation<2> tessellation(grains.sites);
  std::vector<double> x, y, weights, cells, areas, diameters, aspect_ratios, neighbours;
  for (const auto& [position, weight] : grains.sites.sites) {
    x.push_back(position[0]);
    y.push_back(position[1]);
    weights.push_back(weight);
  }
  for (const auto& grain : grain_geometries(tessellation, grains.film)) {
    cells.push_back(grain.cell_volume);
    areas.push_back(grain.grain_volume);
    diameters.push_back(grain.diameter);
    aspect_ratios.push_back(grain.aspect_ratio);
    neighbours.push_back(static_cast<double>(grain.neighbours));
  }
  std::vector<CsvColumn> columns = {{"x_m", x},
                                    {"y_m", y},
                                    {"weight_m2", weights},
                                    {"cell_area_m2", cells},
                                    {"grain_area_m2", areas},
                                    {"equivalent_diameter_m", diameters},
                                    {"aspect_ratio", aspect_ratios},
                                    {"neighbours", neighbours}};
  if (!grains.sites.film_shares.empty()) columns.push_back({"film_share", grains.sites.film_shares});
  write_csv(directory / "grains.csv", columns,
            fmt::format("Grains of stage {} in a box of {} m, with films of {} m between them", stage.name, stage.side,
                        grains.film));
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
  constexpr std::array names = {"x_m", "y_m", "z_m"};
  std::vector<std::vector<double>> coordinates(static_cast<std::size_t>(dim));
  std::vector<double> diameters;
  for (const auto& [centre, diameter] : box.particles) {
    for (std::size_t axis = 0; axis < centre.size(); ++axis) coordinates[axis].push_back(centre[axis]);
    diameters.push_back(diameter);
  }
  std::vector<CsvColumn> columns;
  for (std::size_t axis = 0; axis < coordinates.size(); ++axis) columns.push_back({names[axis], coordinates[axis]});
  columns.push_back({"diameter_m", diameters});
  const std::vector<double> fillers(box.fillers.begin(), box.fillers.end());
  if (!fillers.empty()) columns.push_back({"filler", fillers});
  write_csv(directory / "microstructure.csv", columns,
            fmt::format("Particles of stage {} in a box of {} m", stage.name, stage.side));
}

/// The middle planes of a box of three dimensions; the one seen along z stands for the microstructure.
void write_cuts(const std::filesystem::path& directory, const Stage& stage, const Microstructure<3>& box) {
  const auto fillers = drawn_fillers(stage);
  write_text(directory / "microstructure.svg", cut_picture(box, Axis::z, fillers));
  write_text(directory / "cut-x.svg", cut_picture(box, Axis::x, fillers));
  write_text(directory / "cut-y.svg", cut_picture(box, Axis::y, fillers));
}

}  // namespace

void write_microstructure(const std::filesystem::path& directory, const Stage& stage,
                          const StageMicrostructure& microstructure) {
  write_labels(directory, stage, microstructure);
  if (const auto* image = stage.image()) {
    write_image(directory, stage, *image);
    return;
  }
  if (microstructure.grains) {
    write_grains(directory, stage, *microstructure.grains);
    return;
  }
  if (microstructure.shaped) {
    write_particles(directory, stage, *microstructure.shaped);
    write_text(directory / "microstructure.svg", particle_picture(*microstructure.shaped, drawn_fillers(stage)));
    return;
  }
  if (microstructure.spheres) {
    write_balls(directory, stage, *microstructure.spheres);
    write_cuts(directory, stage, *microstructure.spheres);
    return;
  }
  write_balls(directory, stage, microstructure.microstructure);
  write_text(directory / "microstructure.svg",
             microstructure_picture(microstructure.microstructure, drawn_fillers(stage)));
}

}  // namespace breccia
