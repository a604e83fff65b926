#include "breccia/results/microstructure_files.hpp"

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
  write_csv(directory / "grains.csv",
            {{"x_m", x},
             {"y_m", y},
             {"weight_m2", weights},
             {"cell_area_m2", cells},
             {"grain_area_m2", areas},
             {"equivalent_diameter_m", diameters},
             {"aspect_ratio", aspect_ratios},
             {"neighbours", neighbours}},
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
  std::vector<double> x, y, diameters;
  for (const auto& [centre, diameter] : microstructure.microstructure.particles) {
    x.push_back(centre[0]);
    y.push_back(centre[1]);
    diameters.push_back(diameter);
  }
  std::vector<CsvColumn> columns = {{"x_m", x}, {"y_m", y}, {"diameter_m", diameters}};
  const auto& fillers = microstructure.microstructure.fillers;
  if (!fillers.empty()) columns.push_back({"filler", std::vector<double>(fillers.begin(), fillers.end())});
  write_csv(directory / "microstructure.csv", columns,
            fmt::format("Particles of stage {} in a box of {} m", stage.name, stage.side));
  write_text(directory / "microstructure.svg",
             microstructure_picture(microstructure.microstructure, drawn_fillers(stage)));
}

}  // namespace breccia
