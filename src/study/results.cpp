#include "results.hpp"

#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "breccia/io/csv.hpp"
#include "breccia/io/text_file.hpp"
#include "breccia/io/vtkhdf.hpp"
#include "breccia/report/microstructure_picture.hpp"

namespace breccia {

void write_microstructure(const std::filesystem::path& directory, const Stage& stage,
                          const StageMicrostructure& microstructure) {
  std::vector<double> x, y, diameters;
  for (const auto& [centre, diameter] : microstructure.microstructure.discs) {
    x.push_back(centre[0]);
    y.push_back(centre[1]);
    diameters.push_back(diameter);
  }
  write_csv(directory / "microstructure.csv", {{"x_m", x}, {"y_m", y}, {"diameter_m", diameters}},
            fmt::format("Particles of stage {} in a box of {} m", stage.name, stage.side));
  write_text(directory / "microstructure.svg", microstructure_picture(microstructure.microstructure));
}

void write_fields(const std::filesystem::path& directory, const Grid& grid, const PointFields& fields) {
  const double spacing = 0.5 * grid.cell_side;
  const auto columns = 2 * static_cast<std::size_t>(grid.columns), rows = 2 * static_cast<std::size_t>(grid.rows);
  std::vector<std::int64_t> material(fields.material.begin(), fields.material.end());
  std::vector<double> displacement, strain, stress;
  for (const auto& u : fields.displacement) displacement.insert(displacement.end(), {u[0], u[1], 0.0});
  for (const auto& e : fields.strain) strain.insert(strain.end(), {e[0], e[1], 0.0, e[2], 0.0, 0.0});
  for (const auto& s : fields.stress) stress.insert(stress.end(), {s[0], s[1], s[2], s[3], 0.0, 0.0});
  write_vtkhdf(directory / "fields.vtkhdf", {columns, rows, {0.5 * spacing, 0.5 * spacing}, spacing},
               {{"material", 1, std::move(material)},
                {"displacement_m", 3, std::move(displacement)},
                {"strain", 6, std::move(strain)},
                {"stress_Pa", 6, std::move(stress)}});
}

}  // namespace breccia
