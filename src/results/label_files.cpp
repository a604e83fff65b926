#include "breccia/results/label_files.hpp"

#include <vector>

#include "breccia/homogenisation/point_labels.hpp"
#include "breccia/homogenisation/stage_discretisation.hpp"

#include "rasters/npy.hpp"
#include "rasters/vti.hpp"

namespace breccia {

void write_labels(const std::filesystem::path& directory, const Stage& stage,
                  const StageMicrostructure& microstructure) {
  if (point_count(stage, stage.cells) > most_labelled_points) return;
  const auto labels = point_labels(stage, microstructure, stage.cells);
  const auto along = 2 * static_cast<std::size_t>(stage.cells);
  const std::vector<std::size_t> extents(static_cast<std::size_t>(stage.dimensions()), along);
  write_npy(directory / "labels.npy", extents, labels.phases);
  std::vector<VtiArray> arrays = {{"phase", labels.phases}};
  if (!labels.particles.empty()) {
    arrays.push_back({microstructure.grains() != nullptr ? "grain" : "particle", labels.particles});
  }
  write_vti(directory / "labels.vti", extents, 0.5 * stage.cell_size(), arrays);
}

}  // namespace breccia
