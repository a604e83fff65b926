#include "breccia/io/vtkhdf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"
#include "breccia/io/hdf5.hpp"

#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;

using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;

class VtkHdf : public testing::Test {
 protected:
  test::TemporaryDirectory directory;
  std::filesystem::path path = directory.path() / "fields.vtkhdf";
  Lattice lattice{.nx = 3, .ny = 2, .origin = {0.25, 0.75}, .spacing = 0.5};
};

// The layout that the VTK file format documentation prescribes for version 1.0 of ImageData.
TEST_F(VtkHdf, WritesImageData) {
  write_vtkhdf(path, lattice,
               {{"material", 1, Integers{0, 1, 2, 3, 4, 5}},
                {"displacement", 3, Numbers(18, 0.5)},
                {"stress", 6, Numbers(36, 2.0)}});
  const Hdf5Reader file(path);
  EXPECT_THAT(file.attribute<Integers>("/VTKHDF", "Version"), ElementsAre(1, 0));
  EXPECT_EQ(file.attribute<std::string>("/VTKHDF", "Type"), "ImageData");
  EXPECT_THAT(file.attribute<Integers>("/VTKHDF", "WholeExtent"), ElementsAre(0, 2, 0, 1, 0, 0));
  EXPECT_THAT(file.attribute<Numbers>("/VTKHDF", "Origin"), ElementsAre(0.25, 0.75, 0.0));
  EXPECT_THAT(file.attribute<Numbers>("/VTKHDF", "Spacing"), ElementsAre(0.5, 0.5, 0.5));
  EXPECT_THAT(file.attribute<Numbers>("/VTKHDF", "Direction"), ElementsAre(1, 0, 0, 0, 1, 0, 0, 0, 1));
  EXPECT_THAT(file.names("/VTKHDF/PointData"), ElementsAre("displacement", "material", "stress"));
  EXPECT_THAT(file.shape("/VTKHDF/PointData/material"), ElementsAre(1U, 2U, 3U));
  EXPECT_THAT(file.shape("/VTKHDF/PointData/displacement"), ElementsAre(1U, 2U, 3U, 3U));
  EXPECT_THAT(file.shape("/VTKHDF/PointData/stress"), ElementsAre(1U, 2U, 3U, 6U));
  EXPECT_THAT(file.read_integers("/VTKHDF/PointData/material"), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST_F(VtkHdf, RefusesFieldsThatDoNotFit) {
  EXPECT_THROW(write_vtkhdf(path, lattice, {{"material", 1, Numbers(5)}}), InputError);
  EXPECT_THROW(write_vtkhdf(path, lattice, {{"material", 2, Numbers(12)}}), InputError);
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace breccia
