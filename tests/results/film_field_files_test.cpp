#include "results/film_field_files.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/hdf5.hpp"
#include "io/text_file.hpp"
#include "results/field_files.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A box of 6 mm of three cells: a triangle of a grain, a film and a junction of five corners, with a shear stress of
/// 2, 4 and 0 MPa and a shear strain of 0.1, 0.5 and 1.5.
class FilmFieldFiles : public testing::Test {
 protected:
  FilmFieldFiles() {
    fields.points = {{0.0, 0.0}, {6e-3, 0.0}, {0.0, 3e-3}, {6e-3, 3e-3}, {0.0, 6e-3}, {3e-3, 5e-3}, {6e-3, 6e-3}};
    for (std::size_t i = 0; i < fields.points.size(); ++i) {
      fields.displacement.push_back({static_cast<double>(i), 10.0 + static_cast<double>(i)});
    }
    fields.corners = {0, 1, 2, 1, 3, 2, 0, 2, 3, 6, 5, 4};
    fields.cells = {
        {.part = FilmPart::grain,
         .corners = 3,
         .content = 9e-6,
         .strain = {0.0, 0.0, 0.05},
         .stress = {1.0, 2.0, 3.0, 2e6},
         .work = 1e6},
        {.part = FilmPart::film,
         .corners = 4,
         .content = 9e-6,
         .strain = {0.0, 0.0, 0.25},
         .stress = {4.0, 5.0, 6.0, 4e6},
         .work = 5e6,
         .slip = 7.0,
         .opening = 8.0,
         .flow = 9.0},
        {.part = FilmPart::junction, .corners = 5, .content = 18e-6, .strain = {0.0, 0.0, 0.75}, .work = 1e6}};
  }
  [[nodiscard]] std::vector<FieldRecord> write(Boundary boundary) const {
    return write_fields(directory.path(), study, study.stages[0],
                        {Load::shear, boundary, Method::quasistatic, TestGrid::films()},
                        NetworkFields<2>{{{10e-3, fields}}});
  }

  test::TemporaryDirectory directory;
  Study study = test::two_stages();
  FilmFields<2> fields;
};

TEST_F(FilmFieldFiles, HoldEachComponentInItsPlace) {
  const auto records = write(Boundary::displacement);
  ASSERT_EQ(records.size(), 1U);
  const Hdf5Reader file(directory.path() / "fields.vtkhdf");
  EXPECT_EQ(file.attribute<double>("/VTKHDF", "time_s"), 10e-3);
  const auto values = [&](const std::string& name) { return file.read_numbers("/VTKHDF/" + name); };
  EXPECT_THAT(file.read_integers("/VTKHDF/Types"), ElementsAre(5, 9, 7));
  EXPECT_THAT(file.read_integers("/VTKHDF/CellData/material"), ElementsAre(1, 0, 0));
  EXPECT_THAT(file.read_integers("/VTKHDF/CellData/part"), ElementsAre(0, 1, 2));
  EXPECT_EQ(values("PointData/displacement_m")[3], 1.0);
  EXPECT_EQ(values("PointData/displacement_m")[4], 11.0);
  const auto stress = values("CellData/stress_Pa"), strain = values("CellData/strain");
  EXPECT_THAT(std::vector(stress.begin() + 6, stress.begin() + 12), ElementsAre(4.0, 5.0, 6.0, 4e6, 0.0, 0.0));
  EXPECT_THAT(std::vector(strain.begin() + 6, strain.begin() + 12), ElementsAre(0.0, 0.0, 0.0, 0.25, 0.0, 0.0));
  EXPECT_THAT(values("CellData/work_Pa"), ElementsAre(1e6, 5e6, 1e6));
  EXPECT_THAT(values("CellData/slip_m"), ElementsAre(0.0, 7.0, 0.0));
  EXPECT_THAT(values("CellData/opening_m"), ElementsAre(0.0, 8.0, 0.0));
  EXPECT_THAT(values("CellData/flow_m"), ElementsAre(0.0, 9.0, 0.0));
}

// The areas are a quarter, a quarter and a half of the box.
TEST_F(FilmFieldFiles, HavePictures) {
  const auto record = write(Boundary::displacement).front();
  const auto picture = [&](const std::string& name) { return read_text(directory.path() / name); };
  EXPECT_THAT(picture(record.stress_picture),
              HasSubstr("Shear stress over mean shear strain in MPa; it goes from 0 to 4"));
  EXPECT_THAT(picture(record.strain_picture), HasSubstr("Largest shear strain over mean shear strain; it goes from"));
  EXPECT_THAT(picture(record.work_picture), HasSubstr("Work over its mean; 87.5 % of all is in the binder"));
  EXPECT_THAT(picture(record.work_picture), HasSubstr("it goes from 0.5 to 2.5"));
  EXPECT_THAT(picture(record.work_picture), HasSubstr(study.stages[0].name + ", displacement, quasi-static, 10 ms"));
}

/// A cube of 6 mm of two wedges along z, a grain and a gap, parted by the plane x + y = 6 mm, and a
/// junction that counts for nothing in means.
FilmFields<3> two_wedges() {
  constexpr double side = 6e-3;
  FilmFields<3> fields;
  for (const double z : {side, 0.0}) {
    for (const double y : {0.0, side}) {
      for (const double x : {0.0, side}) fields.points.push_back({x, y, z});
    }
  }
  for (std::size_t i = 0; i < fields.points.size(); ++i)
    fields.displacement.push_back({0.0, 0.0, 1.0 + static_cast<double>(i)});
  fields.corners = {0, 1, 2, 4, 5, 6, 3, 2, 1, 7, 6, 5};
  fields.cells = {{.part = FilmPart::grain,
                   .corners = 6,
                   .content = 0.5 * side * side * side,
                   .strain = {1.0, 2.0, 3.0, 4.0, 5.0, 0.25},
                   .stress = {1.0, 2.0, 3.0, 4.0, 5.0, 6e6},
                   .work = 2e6},
                  {.part = FilmPart::gap,
                   .corners = 6,
                   .content = 0.5 * side * side * side,
                   .strain = {0.0, 0.0, 0.0, 0.0, 0.0, 0.75},
                   .opening = 8.0},
                  {.part = FilmPart::junction, .corners = 4, .work = 1e6}};
  fields.corners.insert(fields.corners.end(), {0, 1, 2, 4});
  return fields;
}

TEST_F(FilmFieldFiles, OfSpaceHoldEachComponentInItsPlace) {
  const auto fields_in_space = two_wedges();
  const auto record = write_fields(directory.path(), study, study.stages[0],
                                   {Load::shear, Boundary::periodic, Method::quasistatic, TestGrid::films()},
                                   NetworkFields<3>{{{10e-3, fields_in_space}}})
                          .front();
  const Hdf5Reader file(directory.path() / record.file);
  const auto values = [&](const std::string& name) { return file.read_numbers("/VTKHDF/" + name); };
  EXPECT_THAT(file.read_integers("/VTKHDF/Types"), ElementsAre(13, 13, 10));
  EXPECT_THAT(file.read_integers("/VTKHDF/CellData/part"), ElementsAre(0, 3, 2));
  EXPECT_EQ(values("PointData/displacement_m")[5], 2.0);
  // xx, yy, zz, xy, yz, xz
  const auto stress = values("CellData/stress_Pa"), strain = values("CellData/strain");
  EXPECT_THAT(std::vector(stress.begin(), stress.begin() + 6), ElementsAre(1.0, 2.0, 3.0, 6e6, 4.0, 5.0));
  EXPECT_THAT(std::vector(strain.begin(), strain.begin() + 6), ElementsAre(1.0, 2.0, 3.0, 0.25, 4.0, 5.0));
  const auto picture = [&](const std::string& name) { return read_text(directory.path() / name); };
  EXPECT_THAT(picture(record.stress_picture), HasSubstr("quasi-static, 10 ms, halfway up the box"));
  // The mean strain xy is 0.5, so that the mean shear strain is 1; the gap, without a stress, is grey.
  EXPECT_THAT(picture(record.stress_picture),
              HasSubstr("Shear stress over mean shear strain in MPa; it goes from 0 to 6"));
}

TEST_F(FilmFieldFiles, AreCopiedWithTheirStage) {
  StageRecord record;
  record.fields = {
      {{Load::shear, Boundary::periodic, Method::quasistatic, TestGrid::films()}, write(Boundary::periodic)}};
  const auto other = directory.path() / "other";
  std::filesystem::create_directory(other);
  copy_fields(directory.path(), other, record);
  const auto names = record.fields.front().files.front().names();
  EXPECT_EQ(names.size(), 4U);
  for (const auto& name : names) {
    EXPECT_TRUE(is_of_fields(name)) << name;
    EXPECT_EQ(read_text(other / name), read_text(directory.path() / name)) << name;
  }
}

}  // namespace
}  // namespace breccia
