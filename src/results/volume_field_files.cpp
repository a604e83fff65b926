#include "results/volume_field_files.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/text_file.hpp"
#include "rasters/vtkhdf.hpp"
#include "report/field_picture.hpp"
#include "results/field_files.hpp"
#include "results/field_pieces.hpp"
#include "results/field_quantities.hpp"
#include "results/volume_quantities.hpp"

namespace breccia {
namespace {

namespace fs = std::filesystem;

std::vector<float> values_for_vtk(const std::vector<CellTensor>& tensors) {
  std::vector<float> values;
  values.reserve(6 * tensors.size());
  for (const auto& tensor : tensors) {
    for (const double component : in_order_of_vtk(tensor)) values.push_back(static_cast<float>(component));
  }
  return values;
}

CubeLattice lattice_of(const Grid<3>& grid) {
  CubeLattice lattice{.spacing = grid.cell_side};
  for (std::size_t axis = 0; axis < 3; ++axis) lattice.cubes[axis] = static_cast<std::size_t>(grid.cells[axis]);
  return lattice;
}

/// Values in the cells just above the middle planes, by the axis along which these are seen (FieldCutsPicture), and the
/// mean over all cells of the value that determines the unit of their labels.
class MiddleCuts {
 public:
  explicit MiddleCuts(const Grid<3>& grid) : grid_(grid) {
    for (std::size_t normal = 0; normal < 3; ++normal) {
      const auto across = static_cast<std::size_t>(grid.cells[(normal + 1) % 3]);
      cuts_[normal].resize(across * static_cast<std::size_t>(grid.cells[(normal + 2) % 3]));
    }
  }

  void add(std::size_t place, double value, double of_load) {
    sum_ += of_load;
    const auto cell = grid_.cell_at(place);
    for (std::size_t normal = 0; normal < 3; ++normal) {
      if (cell[normal] != grid_.cells[normal] / 2) continue;
      const auto across = (normal + 1) % 3, up = (normal + 2) % 3;
      cuts_[normal][static_cast<std::size_t>(cell[up]) * static_cast<std::size_t>(grid_.cells[across]) +
                    static_cast<std::size_t>(cell[across])] = value;
    }
  }

  [[nodiscard]] double mean() const { return sum_ / static_cast<double>(grid_.cell_count()); }
  [[nodiscard]] const std::array<std::vector<double>, 3>& cuts() const noexcept { return cuts_; }

 private:
  Grid<3> grid_;
  std::array<std::vector<double>, 3> cuts_;
  double sum_ = 0.0;
};

/// The file and the pictures of the fields of the cells of a cube, from their pieces.
class FieldsOfCube {
 public:
  FieldsOfCube(const fs::path& path, const Grid<3>& grid, double time, Load load)
      : load_(load), file_(path, lattice_of(grid), {{"time_s", time}}), stress_(grid), strain_(grid) {
    file_.add_field<std::uint8_t>("material", 1);
    file_.add_field<float>("displacement_m", 3);
    file_.add_field<float>("strain", 6);
    file_.add_field<float>("stress_Pa", 6);
  }

  void take(std::size_t first, const CellFields<3>& piece) {
    std::vector<float> displacement;
    for (const auto& u : piece.displacement) displacement.insert(displacement.end(), u.begin(), u.end());
    // The phases fit into a byte, because a stage has few: a mixture counts as its largest part.
    file_.write("material", first, std::vector<std::uint8_t>(piece.phase.begin(), piece.phase.end()));
    file_.write("displacement_m", first, displacement);
    file_.write("strain", first, values_for_vtk(piece.strain));
    file_.write("stress_Pa", first, values_for_vtk(piece.stress));
    for (std::size_t i = 0; i < piece.phase.size(); ++i) {
      const double stress = stress_under(load_, piece.stress[i]);
      stress_.add(first + i, stress, stress);
      strain_.add(first + i, equivalent_shear(piece.strain[i]), strain_under(load_, piece.strain[i]));
    }
  }

  void commit() { file_.commit(); }

  [[nodiscard]] FieldCutsPicture stress_picture(Boundary boundary) const {
    return picture_of(stress_, stress_in_space(boundary, load_, stress_.mean()), ColourScale::linear);
  }
  [[nodiscard]] FieldCutsPicture strain_picture() const {
    return picture_of(strain_, strain_in_space(load_, strain_.mean()), ColourScale::logarithmic);
  }

 private:
  static FieldCutsPicture picture_of(const MiddleCuts& middle, FieldQuantity quantity, ColourScale scale) {
    return {
        .quantity = std::move(quantity.words), .unit_size = quantity.unit_size, .cuts = middle.cuts(), .scale = scale};
  }

  Load load_;
  VtkhdfFile file_;
  MiddleCuts stress_, strain_;
};

}  // namespace

std::vector<FieldRecord> write_fields(const fs::path& directory, const Study& study, const Stage& stage,
                                      const TestId& test, const GridFields<3>& fields) {
  auto records = field_records(study, test, times_of(fields));
  const auto& grid = fields.grid;
  for (std::size_t i = 0; i < fields.at_times.size(); ++i) {
    const auto& [time, own] = fields.at_times[i];
    const auto& record = records[i];
    std::optional<FieldsOfCube> all;
    const auto draw = [&, title = field_title(stage, test, time)](const std::string& file, FieldCutsPicture picture) {
      picture.title = title;
      picture.columns = static_cast<std::size_t>(grid.cells[0]);
      picture.side = stage.side;
      write_text(directory / file, field_cuts_picture(picture));
    };
    collect_fields(
        grid, own, [&, time = time] { all.emplace(directory / record.file, grid, time, test.load.of_test().value()); },
        [&](std::size_t first, const CellFields<3>& piece) { all->take(first, piece); },
        [&] {
          all->commit();
          draw(record.stress_picture, all->stress_picture(test.boundary));
          draw(record.strain_picture, all->strain_picture());
        });
  }
  return records;
}

}  // namespace breccia
