#include "results/field_files.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"
#include "io/text_file.hpp"
#include "study/two_stages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Fields of a box of 2 x 2 cells of 1 mm, 4 x 4 points; all zero.
class FieldFiles : public testing::Test {
 protected:
  FieldFiles() {
    discretisation.paint([](const Vector<2>& point) { return point[0] < 0.5e-3 && point[1] < 0.5e-3; }, 1);
    fields = zero_fields(discretisation);
  }
  /// Writes the fields of a test at 10 ms.
  [[nodiscard]] std::vector<FieldRecord> write(Load load, Boundary boundary) const {
    return write_fields(directory.path(), study, study.stages[0], {load, boundary, Method::quasistatic, TestGrid(2)},
                        GridFields<2>{discretisation.grid(), {{10e-3, fields}}});
  }
  [[nodiscard]] std::string picture(const std::string& name) const { return read_text(directory.path() / name); }

  test::TemporaryDirectory directory;
  Study study = test::two_stages();
  Discretisation<2> discretisation{{{2, 2}, 1e-3}};
  PointFields<2> fields;
};

TEST_F(FieldFiles, HoldEachComponentInItsPlace) {
  for (std::size_t i = 0; i < 16; ++i) {
    const auto number = static_cast<double>(i);
    fields.displacement[i] = {number, 100.0 + number};
    fields.strain[i] = {200.0 + number, 300.0 + number, 400.0 + number};
    fields.stress[i] = {500.0 + number, 600.0 + number, 700.0 + number, 800.0 + number};
  }
  static_cast<void>(write(Load::shear, Boundary::displacement));
  const Hdf5Reader file(directory.path() / "fields.vtkhdf");
  EXPECT_EQ(file.attribute<double>("/VTKHDF", "time_s"), 10e-3);
  const auto values = [&](const std::string& name, std::size_t components, std::size_t point) {
    const auto all = file.read_numbers("/VTKHDF/CellData/" + name);
    EXPECT_EQ(all.size(), 16 * components) << name;
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(components * point);
    return std::vector(begin, begin + static_cast<std::ptrdiff_t>(components));
  };
  for (const std::size_t point : {0U, 5U, 15U}) {
    const auto number = static_cast<double>(point);
    EXPECT_THAT(values("displacement_m", 3, point), ElementsAre(number, 100.0 + number, 0.0));
    EXPECT_THAT(values("strain", 6, point), ElementsAre(200.0 + number, 300.0 + number, 0.0, 400.0 + number, 0.0, 0.0))
        << "xx, yy, zz, xy, yz, xz";
    EXPECT_THAT(values("stress_Pa", 6, point),
                ElementsAre(500.0 + number, 600.0 + number, 700.0 + number, 800.0 + number, 0.0, 0.0));
  }
  EXPECT_THAT(file.read_integers("/VTKHDF/CellData/material"),
              ElementsAre(1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
  // The squares of the points have half the side of a cell.
  EXPECT_THAT(file.read_numbers("/VTKHDF/Points").at(3), testing::DoubleNear(0.5e-3, 1e-9));
}

TEST_F(FieldFiles, AreNamedByWhatTellsThemApart) {
  const auto names = [&](const TestId& test, std::size_t times) {
    GridFields<2> timed{discretisation.grid(), {}};
    for (std::size_t i = 0; i < times; ++i) timed.at_times.push_back({1e-3 * static_cast<double>(i + 1), fields});
    std::vector<std::string> files;
    for (const auto& record : write_fields(directory.path(), study, study.stages[0], test, timed)) {
      EXPECT_EQ(record.time, 1e-3 * static_cast<double>(files.size() + 1));
      for (const auto& name : {record.file, record.stress_picture, record.strain_picture}) {
        EXPECT_TRUE(is_of_fields(name)) << name;
        EXPECT_TRUE(std::filesystem::exists(directory.path() / name)) << name;
      }
      files.push_back(record.file);
    }
    return files;
  };
  study.tests.methods = {Method::quasistatic, Method::dynamic};
  const TestId first{Load::shear, Boundary::displacement, Method::quasistatic, TestGrid(2)};
  EXPECT_THAT(names(first, 3), ElementsAre("fields-1.vtkhdf", "fields-2.vtkhdf", "fields.vtkhdf"));
  EXPECT_THAT(names({first.load, Boundary::traction, first.method, first.grid}, 2),
              ElementsAre("fields-traction-quasistatic-1.vtkhdf", "fields-traction-quasistatic.vtkhdf"));
  EXPECT_THAT(names({first.load, first.boundary, Method::dynamic, first.grid}, 1),
              ElementsAre("fields-displacement-dynamic.vtkhdf"));
}

TEST_F(FieldFiles, AreCopiedWithTheirStage) {
  const TestId test{Load::shear, Boundary::displacement, Method::quasistatic, TestGrid(2)};
  StageRecord record;
  record.fields = {{test, write(Load::shear, Boundary::displacement)}};
  const auto other = directory.path() / "other";
  std::filesystem::create_directory(other);
  copy_fields(directory.path(), other, record);
  for (const auto* name : {"fields.vtkhdf", "fields-stress.svg", "fields-strain.svg"}) {
    EXPECT_EQ(read_text(other / name), read_text(directory.path() / name)) << name;
  }
  EXPECT_EQ(record.fields_of(test).size(), 1U);
  EXPECT_TRUE(record.fields_of({test.load, Boundary::traction, test.method, test.grid}).empty());
  std::filesystem::remove(directory.path() / "fields-stress.svg");
  EXPECT_THROW(copy_fields(directory.path(), other, record), FileError);
}

// The fields of a test that was done before are not written again.
TEST_F(FieldFiles, HaveTheSameNamesWithoutTheirNumbers) {
  const TestId test{Load::shear, Boundary::traction, Method::quasistatic, TestGrid(2)};
  const auto written = write_fields(directory.path(), study, study.stages[0], test,
                                    GridFields<2>{discretisation.grid(), {{1e-3, fields}, {10e-3, fields}}});
  const auto named = field_records(study, test, {1e-3, 10e-3});
  ASSERT_EQ(named.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(named[i].time, written[i].time);
    EXPECT_EQ(named[i].file, written[i].file);
    EXPECT_EQ(named[i].stress_picture, written[i].stress_picture);
    EXPECT_EQ(named[i].strain_picture, written[i].strain_picture);
  }
}

TEST_F(FieldFiles, AreKnownByTheirNames) {
  for (const auto* name : {"fields", "fields.svg", "my-fields.vtkhdf", "fields/x.vtkhdf", "../fields.vtkhdf", "",
                           "fields-mine-stress.svg", "fields-2-mine.vtkhdf", "fields-traction.vtkhdf",
                           "fields-traction-quasistatic-.vtkhdf", "fields2.vtkhdf", "-stress.svg"}) {
    EXPECT_FALSE(is_of_fields(name)) << name;
  }
}

// Half of the points have a shear stress of 1 MPa, half of 3 MPa; their strains are 0.25 and 0.75, half of the
// engineering shears.
TEST_F(FieldFiles, ShowTheStressAndTheStrainThatALoadRaises) {
  for (std::size_t i = 0; i < 16; ++i) {
    fields.stress[i][3] = i < 8 ? 1e6 : 3e6;
    fields.strain[i][2] = i < 8 ? 0.25 : 0.75;
  }
  const auto records = write(Load::shear, Boundary::displacement);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_THAT(picture(records[0].stress_picture),
              AllOf(HasSubstr(">fine, displacement, quasi-static, 10 ms<"),
                    HasSubstr(">Shear stress over mean shear strain in MPa; it goes from 1 to 3<")));
  EXPECT_THAT(picture(records[0].strain_picture),
              HasSubstr(">Largest shear strain over mean shear strain; it goes from 0.5 to 1.5<"));
}

// A traction of 1 Pa causes stresses that are shares of it.
TEST_F(FieldFiles, ShowStressesOverTheTraction) {
  for (std::size_t i = 0; i < 16; ++i) {
    fields.stress[i][3] = i < 8 ? 0.5 : 1.5;
    fields.strain[i][2] = 1e-6;
  }
  const auto records = write(Load::shear, Boundary::traction);
  EXPECT_THAT(picture(records.at(0).stress_picture),
              AllOf(HasSubstr(">fine, traction, quasi-static, 10 ms<"),
                    HasSubstr(">Shear stress over that applied; it goes from 0.5 to 1.5<")));
}

// The mean of 2 and 4 kPa is that of the stresses along both axes; strains of 3 and 1 along them are sheared by 2 on a
// dilatation of 4.
TEST_F(FieldFiles, ShowDilatationUnderTheBulkLoad) {
  for (std::size_t i = 0; i < 16; ++i) {
    fields.stress[i] = {2e3, 4e3, 100e3, 0.0};
    fields.strain[i] = {3.0, 1.0, 0.0};
  }
  const auto records = write(Load::bulk, Boundary::displacement);
  EXPECT_THAT(picture(records.at(0).stress_picture),
              HasSubstr(">Mean in-plane stress over mean dilatation in kPa; it goes from 3 to 3<"));
  EXPECT_THAT(picture(records.at(0).strain_picture),
              HasSubstr(">Largest shear strain over mean dilatation; it goes from 0.5 to 0.5<"));
}

}  // namespace
}  // namespace breccia
