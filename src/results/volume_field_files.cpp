#include "breccia/results/volume_field_files.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "breccia/io/text_file.hpp"
#include "breccia/io/vtkhdf.hpp"
#include "breccia/report/field_picture.hpp"
#include "breccia/results/field_files.hpp"

#include "field_quantities.hpp"
#include "volume_quantities.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

/// Components in the order of VTK: xx, yy, zz, xy, yz, xz.
std::vector<float> in_order_of_vtk(const std::vector<std::array<double, 6>>& tensors) {
  std::vector<float> values;
  values.reserve(6 * tensors.size());
  for (const auto& [xx, yy, zz, yz, zx, xy] : tensors) {
    for (const double component : {xx, yy, zz, xy, yz, zx}) values.push_back(static_cast<float>(component));
  }
  return values;
}

void write_volume_file(const fs::path& path, const Grid<3>& grid, const TimedFields<3>& timed) {
  const auto& fields = timed.fields;
  CubeLattice lattice{.spacing = grid.cell_side};
  for (std::size_t axis = 0; axis < 3; ++axis) lattice.cubes[axis] = static_cast<std::size_t>(grid.cells[axis]);
  std::vector<float> displacement;
  displacement.reserve(3 * fields.displacement.size());
  for (const auto& u : fields.displacement) {
    for (const double component : u) displacement.push_back(static_cast<float>(component));
  }
  // The phases are those of a stage, which are few: mixtures have been told apart by their largest part.
  std::vector<std::uint8_t> phases(fields.phase.begin(), fields.phase.end());
  write_vtkhdf(path, lattice,
               {{"material", 1, std::move(phases)},
                {"displacement_m", 3, std::move(displacement)},
                {"strain", 6, in_order_of_vtk(fields.strain)},
                {"stress_Pa", 6, in_order_of_vtk(fields.stress)}},
               {{"time_s", timed.time}});
}

/// Values in the cells just above the middle planes, by the axis along which these are seen (FieldCutsPicture).
std::array<std::vector<double>, 3> middle_cuts(const Grid<3>& grid, const std::vector<double>& values) {
  std::array<std::vector<double>, 3> cuts;
  for (std::size_t normal = 0; normal < 3; ++normal) {
    const std::size_t across = (normal + 1) % 3, up = (normal + 2) % 3;
    Index<3> cell{};
    cell[normal] = grid.cells[normal] / 2;
    for (cell[up] = 0; cell[up] < grid.cells[up]; ++cell[up]) {
      for (cell[across] = 0; cell[across] < grid.cells[across]; ++cell[across]) {
        cuts[normal].push_back(values[grid.cell_index(cell)]);
      }
    }
  }
  return cuts;
}

}  // namespace

std::vector<FieldRecord> write_volume_fields(const fs::path& directory, const Study& study, const Stage& stage,
                                             const TestId& test, const Discretisation<3>& discretisation,
                                             const std::vector<TimedFields<3>>& fields) {
  std::vector<double> times;
  for (const auto& timed : fields) times.push_back(timed.time);
  auto records = field_records(study, test, times);
  const auto& grid = discretisation.grid();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto& record = records[i];
    write_volume_file(directory / record.file, grid, fields[i]);
    const auto draw = [&, time = fields[i].time](const std::string& file, const VolumeQuantity& quantity) {
      write_text(directory / file, field_cuts_picture({.title = field_title(stage, test, time),
                                                       .quantity = quantity.words,
                                                       .unit_size = quantity.unit_size,
                                                       .columns = static_cast<std::size_t>(grid.cells[0]),
                                                       .cuts = middle_cuts(grid, quantity.values),
                                                       .scale = quantity.scale,
                                                       .side = stage.side}));
    };
    draw(record.stress_picture, stress_in_cells(fields[i].fields.stress, test.load, test.boundary));
    draw(record.strain_picture, strain_in_cells(fields[i].fields.strain, test.load));
  }
  return records;
}

}  // namespace breccia
