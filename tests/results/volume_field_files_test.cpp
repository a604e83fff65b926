#include "results/volume_field_files.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/hdf5.hpp"
#include "io/text_file.hpp"
#include "report/embedded_pictures.hpp"
#include "results/field_files.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Fields of a cube of 2 x 2 x 2 cells of 1 mm, one of which is of material 1; all zero.
class VolumeFieldFiles : public testing::Test {
 protected:
  VolumeFieldFiles() {
    discretisation.fill({1, 0, 0}, 1);
    fields = zero_cell_fields(discretisation);
  }
  /// Writes the fields of a test at 10 ms.
  [[nodiscard]] FieldRecord write(Load load, Boundary boundary) const {
    return write_fields(directory.path(), study, study.stages[0], {load, boundary, Method::quasistatic, TestGrid(2)},
                        GridFields<3>{discretisation.grid(), {{10e-3, fields}}})
        .front();
  }
  [[nodiscard]] std::string picture(const std::string& name) const { return read_text(directory.path() / name); }

  test::TemporaryDirectory directory;
  Study study = test::two_stages();
  Discretisation<3> discretisation{{{2, 2, 2}, 1e-3}};
  CellFields<3> fields;
};

TEST_F(VolumeFieldFiles, HoldEachComponentInItsPlace) {
  for (std::size_t i = 0; i < 8; ++i) {
    const auto number = static_cast<double>(i);
    fields.displacement[i] = {number, 10.0 + number, 20.0 + number};
    for (std::size_t k = 0; k < 6; ++k) {
      fields.strain[i][k] = 100.0 * static_cast<double>(k + 1) + number;
      fields.stress[i][k] = 1000.0 * static_cast<double>(k + 1) + number;
    }
  }
  const auto record = write(Load::shear, Boundary::displacement);
  EXPECT_EQ(record.file, "fields.vtkhdf");
  const Hdf5Reader file(directory.path() / record.file);
  EXPECT_EQ(file.attribute<double>("/VTKHDF", "time_s"), 10e-3);
  const auto values = [&](const std::string& name, std::size_t components, std::size_t cell) {
    const auto all = file.read_numbers("/VTKHDF/CellData/" + name);
    EXPECT_EQ(all.size(), 8 * components) << name;
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(components * cell);
    return std::vector(begin, begin + static_cast<std::ptrdiff_t>(components));
  };
  EXPECT_THAT(values("displacement_m", 3, 5), ElementsAre(5.0, 15.0, 25.0));
  // Voigt's order xx, yy, zz, yz, zx, xy becomes that of VTK, xx, yy, zz, xy, yz, xz.
  EXPECT_THAT(values("strain", 6, 5), ElementsAre(105.0, 205.0, 305.0, 605.0, 405.0, 505.0));
  EXPECT_THAT(values("stress_Pa", 6, 7), ElementsAre(1007.0, 2007.0, 3007.0, 6007.0, 4007.0, 5007.0));
  EXPECT_THAT(file.read_integers("/VTKHDF/CellData/material"), ElementsAre(0, 1, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(file.read_numbers("/VTKHDF/Points").at(3), testing::DoubleNear(1e-3, 1e-9)) << "the side of a cell";
}

// Half of the cells have a shear stress of 1 MPa, half of 3 MPa; their strains are 0.25 and 0.75, half of the
// engineering shears.
TEST_F(VolumeFieldFiles, ShowTheStressAndTheStrainThatALoadRaises) {
  for (std::size_t i = 0; i < 8; ++i) {
    fields.stress[i][3] = i < 4 ? 1e6 : 3e6;
    fields.strain[i][3] = i < 4 ? 0.25 : 0.75;
  }
  const auto record = write(Load::shear_yz, Boundary::periodic);
  EXPECT_THAT(picture(record.stress_picture),
              AllOf(HasSubstr(">fine, "), HasSubstr("seen along x"),
                    HasSubstr(">Shear stress over mean shear strain in MPa; it goes from 1 to 3<")));
  EXPECT_THAT(picture(record.strain_picture),
              HasSubstr(">Equivalent shear strain over mean shear strain; it goes from 0.5 to 1.5<"));
}

// The middle planes show the cells above them; the values of the cells below are not shown.
TEST_F(VolumeFieldFiles, ShowTheMiddlePlanes) {
  for (auto& stress : fields.stress) stress = {3e3, 3e3, 3e3, 0.0, 0.0, 0.0};
  for (auto& strain : fields.strain) strain = {3.0, 1.0, 2.0, 0.0, 0.0, 0.0};
  fields.stress.front() = {24e3, 24e3, 24e3, 0.0, 0.0, 0.0};
  const auto record = write(Load::bulk, Boundary::displacement);
  EXPECT_THAT(picture(record.stress_picture),
              HasSubstr(">Mean stress over mean dilatation in kPa; it goes from 3 to 3<"));
  // The deviator is (1, -1, 0) on a dilatation of 6.
  EXPECT_THAT(picture(record.strain_picture),
              HasSubstr(">Equivalent shear strain over mean dilatation; it goes from 0.333 to 0.333<"));
  EXPECT_THAT(picture(write(Load::bulk, Boundary::traction).stress_picture),
              HasSubstr(">Mean stress over that applied; it goes from "));
}

// Every cell has a different stress, so that a cut through other cells, or a turned one, has other colours.
TEST(VolumeFieldPictures, ShowTheCellsAboveTheMiddlePlanes) {
  constexpr int cells = 4;
  Discretisation<3> discretisation{{{cells, cells, cells}, 1e-3}};
  auto fields = zero_cell_fields(discretisation);
  const auto stress_of = [](int x, int y, int z) { return 1e3 * (1 + x + 5 * y + 23 * z); };
  discretisation.grid().for_each_cell([&](const Index<3>& cell) {
    fields.stress[discretisation.grid().cell_index(cell)][5] = stress_of(cell[0], cell[1], cell[2]);
  });
  const test::TemporaryDirectory directory;
  const auto study = test::two_stages();
  const auto record = write_fields(directory.path(), study, study.stages[0],
                                   {Load::shear, Boundary::traction, Method::quasistatic, TestGrid(cells)},
                                   GridFields<3>{discretisation.grid(), {{1.0, fields}}})
                          .front();
  // Seen along z, along x and along y; across and up follow in the cycle x, y, z.
  std::array<std::vector<double>, 3> cuts;
  for (int up = 0; up < cells; ++up) {
    for (int across = 0; across < cells; ++across) {
      cuts[0].push_back(stress_of(across, up, 2));
      cuts[1].push_back(stress_of(2, across, up));
      cuts[2].push_back(stress_of(up, 2, across));
    }
  }
  std::vector<double> all;
  for (const auto& cut : cuts) all.insert(all.end(), cut.begin(), cut.end());
  std::ranges::sort(all);
  // The 1st and the 99th percentile of 48 values.
  const double from = all[0], to = all[46];
  const auto pictures = test::embedded_pictures(read_text(directory.path() / record.stress_picture));
  ASSERT_EQ(pictures.size(), 4U) << "the last one is the colour bar";
  for (std::size_t cut = 0; cut < 3; ++cut) {
    EXPECT_THAT(pictures[cut].extents, ElementsAre(4, 4));
    for (std::size_t place = 0; place < cuts[cut].size(); ++place) {
      const double colour = 255.0 * std::min(1.0, (cuts[cut][place] - from) / (to - from));
      EXPECT_NEAR(pictures[cut].values.at(place), colour, 0.51) << "cut " << cut << ", place " << place;
    }
  }
}

}  // namespace
}  // namespace breccia
