#include "rasters/vtkhdf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/hdf5.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;

using Floats = std::vector<float>;
using Bytes = std::vector<std::uint8_t>;
using Integers = std::vector<std::int64_t>;

class VtkHdf : public testing::Test {
 protected:
  test::TemporaryDirectory directory;
  std::filesystem::path path = directory.path() / "fields.vtkhdf";
  PlaneLattice lattice{.nx = 3, .ny = 2, .origin = {0.25, 0.75}, .spacing = 0.5};
};

// The layout that the VTK file format documentation prescribes for version 1.0 of UnstructuredGrid.
TEST_F(VtkHdf, WritesASquareForEachValue) {
  VtkhdfFile written(path, lattice, {{"time_s", 1e-3}});
  written.add_field<std::uint8_t>("material", 1);
  written.write("material", 4, Bytes{4, 5});
  written.write("material", 0, Bytes{0, 1, 2, 3});
  written.add_field<float>("displacement", 3);
  written.write("displacement", 0, Floats(18, 0.5F));
  written.add_field<float>("stress", 6);
  written.write("stress", 0, Floats(36, 2.0F));
  written.commit();
  const Hdf5Reader file(path);
  EXPECT_THAT(file.attribute<Integers>("/VTKHDF", "Version"), ElementsAre(1, 0));
  EXPECT_EQ(file.attribute<std::string>("/VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_EQ(file.attribute<double>("/VTKHDF", "time_s"), 1e-3);
  EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfPoints"), ElementsAre(12));
  EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfCells"), ElementsAre(6));
  EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfConnectivityIds"), ElementsAre(24));
  EXPECT_THAT(file.shape("/VTKHDF/Points"), ElementsAre(12U, 3U));
  const auto points = file.read_numbers("/VTKHDF/Points");
  EXPECT_THAT(std::vector(points.begin(), points.begin() + 6), ElementsAre(0.25, 0.75, 0.0, 0.75, 0.75, 0.0));
  const auto corners = file.read_integers("/VTKHDF/Connectivity");
  EXPECT_THAT(std::vector(corners.begin(), corners.begin() + 4), ElementsAre(0, 1, 5, 4));
  EXPECT_THAT(std::vector(corners.end() - 4, corners.end()), ElementsAre(6, 7, 11, 10));
  EXPECT_THAT(file.read_integers("/VTKHDF/Offsets"), ElementsAre(0, 4, 8, 12, 16, 20, 24));
  EXPECT_THAT(file.read_integers("/VTKHDF/Types"), ElementsAre(9, 9, 9, 9, 9, 9));
  EXPECT_THAT(file.names("/VTKHDF/CellData"), ElementsAre("displacement", "material", "stress"));
  EXPECT_THAT(file.shape("/VTKHDF/CellData/material"), ElementsAre(6U));
  EXPECT_THAT(file.shape("/VTKHDF/CellData/displacement"), ElementsAre(6U, 3U));
  EXPECT_THAT(file.shape("/VTKHDF/CellData/stress"), ElementsAre(6U, 6U));
  EXPECT_THAT(file.read_integers("/VTKHDF/CellData/material"), ElementsAre(0, 1, 2, 3, 4, 5));
}

// A triangle, a square and a pentagon share points; the types are those of VTK.
TEST_F(VtkHdf, WritesPolygons) {
  const PieceMesh<2> mesh = {.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.5, 2.0}},
                             .corners = {0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 4, 3},
                             .corner_counts = {3, 4, 5}};
  write_vtkhdf(path, mesh, {{"part", 1, Bytes{0, 1, 2}}}, {{"displacement_m", 3, Floats(15, 0.5F)}}, {});
  const Hdf5Reader file(path);
  EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfPoints"), ElementsAre(5));
  EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfCells"), ElementsAre(3));
  EXPECT_THAT(file.read_integers("/VTKHDF/Offsets"), ElementsAre(0, 3, 7, 12));
  EXPECT_THAT(file.read_integers("/VTKHDF/Types"), ElementsAre(5, 9, 7));
  EXPECT_THAT(file.read_integers("/VTKHDF/Connectivity"), ElementsAre(0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 4, 3));
  EXPECT_THAT(file.read_integers("/VTKHDF/CellData/part"), ElementsAre(0, 1, 2));
  EXPECT_THAT(file.shape("/VTKHDF/PointData/displacement_m"), ElementsAre(5U, 3U));
}

// A wedge and a tetrahedron on its upper side; the types are those of VTK.
TEST_F(VtkHdf, WritesTetrahedraAndWedges) {
  const PieceMesh<3> mesh = {.points = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}},
                             .corners = {0, 1, 2, 3, 4, 5, 0, 1, 2, 6},
                             .corner_counts = {6, 4}};
  write_vtkhdf(path, mesh, {{"part", 1, Bytes{1, 0}}}, {}, {});
  const Hdf5Reader file(path);
  EXPECT_THAT(file.read_integers("/VTKHDF/Types"), ElementsAre(13, 10));
  EXPECT_THAT(file.read_integers("/VTKHDF/Offsets"), ElementsAre(0, 6, 10));
  EXPECT_EQ(file.read_numbers("/VTKHDF/Points")[20], 2.0);
  auto wrong = mesh;
  wrong.corner_counts = {5, 5};
  EXPECT_THROW(write_vtkhdf(path, wrong, {}, {}, {}), InputError) << "there are no pieces of five corners";
}

TEST_F(VtkHdf, RefusesPolygonsThatDoNotFit) {
  const PieceMesh<2> triangle = {
      .points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}, .corners = {0, 1, 2}, .corner_counts = {3}};
  EXPECT_THROW(write_vtkhdf(path, triangle, {{"part", 1, Bytes{0, 1}}}, {}, {}), InputError);
  EXPECT_THROW(write_vtkhdf(path, triangle, {}, {{"part", 1, Bytes{0, 1}}}, {}), InputError);
  auto wrong = triangle;
  wrong.corners.back() = 3;
  EXPECT_THROW(write_vtkhdf(path, wrong, {}, {}, {}), InputError) << "no such point";
  wrong = triangle;
  wrong.corner_counts = {2};
  EXPECT_THROW(write_vtkhdf(path, wrong, {}, {}, {}), InputError);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(VtkHdf, RefusesFieldsThatDoNotFit) {
  {
    VtkhdfFile file(path, lattice, {});
    EXPECT_THROW(file.add_field<float>("material", 2), InputError);
    file.add_field<float>("material", 1);
    EXPECT_THROW(file.write("material", 2, Floats(5)), FileError);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

// Cubes are VTK's hexahedra: the corners of the lower side anticlockwise, then those above them.
TEST_F(VtkHdf, WritesACubeForEachValue) {
  const CubeLattice cubes{.cubes = {3, 2, 1}, .origin = {0.25, 0.75, 1.25}, .spacing = 0.5};
  VtkhdfFile written(path, cubes, {{"time_s", 1e-3}});
  written.add_field<std::uint8_t>("material", 1);
  written.write("material", 0, Bytes{0, 1, 2, 3, 4, 5});
  written.add_field<float>("stress", 6);
  written.write("stress", 0, Floats(36, 2.0F));
  written.commit();
  const Hdf5Reader file(path);
  EXPECT_EQ(file.attribute<std::string>("/VTKHDF", "Type"), "UnstructuredGrid");
  EXPECT_EQ(file.attribute<double>("/VTKHDF", "time_s"), 1e-3);
  EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfPoints"), ElementsAre(24));
  EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfCells"), ElementsAre(6));
  EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfConnectivityIds"), ElementsAre(48));
  const auto points = file.read_numbers("/VTKHDF/Points");
  EXPECT_THAT(std::vector(points.begin(), points.begin() + 6), ElementsAre(0.25, 0.75, 1.25, 0.75, 0.75, 1.25));
  EXPECT_THAT(std::vector(points.end() - 3, points.end()), ElementsAre(1.75, 1.75, 1.75));
  const auto corners = file.read_integers("/VTKHDF/Connectivity");
  EXPECT_THAT(std::vector(corners.begin(), corners.begin() + 8), ElementsAre(0, 1, 5, 4, 12, 13, 17, 16));
  EXPECT_THAT(std::vector(corners.end() - 8, corners.end()), ElementsAre(6, 7, 11, 10, 18, 19, 23, 22));
  EXPECT_THAT(file.read_integers("/VTKHDF/Offsets"), ElementsAre(0, 8, 16, 24, 32, 40, 48));
  EXPECT_THAT(file.read_integers("/VTKHDF/Types"), ElementsAre(12, 12, 12, 12, 12, 12));
  EXPECT_THAT(file.read_integers("/VTKHDF/CellData/material"), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(file.shape("/VTKHDF/CellData/stress"), ElementsAre(6U, 6U));
}

}  // namespace
}  // namespace breccia
