#include "breccia/results/microstructure_files.hpp"

#include <vector>

#include <fmt/format.h>

#include "breccia/io/csv.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/report/microstructure_picture.hpp"

namespace breccia {

void write_microstructure(const std::filesystem::path& directory, const Stage& stage,
                          const StageMicrostructure& microstructure) {
  std::vector<double> x, y, diameters;
  for (const auto& [centre, diameter] : microstructure.microstructure.particles) {
    x.push_back(centre[0]);
    y.push_back(centre[1]);
    diameters.push_back(diameter);
  }
  write_csv(directory / "microstructure.csv", {{"x_m", x}, {"y_m", y}, {"diameter_m", diameters}},
            fmt::format("Particles of stage {} in a box of {} m", stage.name, stage.side));
  write_text(directory / "microstructure.svg", microstructure_picture(microstructure.microstructure));
}

}  // namespace breccia
