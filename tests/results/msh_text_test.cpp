#include "results/meshes/msh_text.hpp"

#include <gmock/gmock.h>

#include "results/mesh_parsers.hpp"

namespace breccia {
namespace {

using films::Beyond;
using testing::ElementsAre;
using testing::Pair;

/// A unit square of two triangles, one of which is a grain; its left and right sides are periodic.
films::ConformingMesh<2> two_triangles() {
  return {.side = 1.0,
          .walls = Walls::periodic,
          .nodes = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}},
          .elements = {{{0, 1, 2}, 0}, {{0, 2, 3}, std::nullopt}},
          .surfaces = {{Beyond::image, {-1, 0}, {{3, 0}}}, {Beyond::image, {1, 0}, {{1, 2}}}, {Beyond::gap, {}, {}}},
          .opposites = {{0, 1, {1, 0}, {{0, 1}, {3, 2}}}}};
}

TEST(MshText, HasPhasesGrainsAndPeriodicSides) {
  const auto msh = test::parse_msh(msh_text(two_triangles(), {"hmx", "a \"soft\" binder"}, 1e3));
  EXPECT_THAT(msh.groups, ElementsAre(Pair("a 'soft' binder", ElementsAre(2, 2)), Pair("gap", ElementsAre(1, 5)),
                                      Pair("hmx", ElementsAre(2, 1)), Pair("side_x_minus", ElementsAre(1, 3)),
                                      Pair("side_x_plus", ElementsAre(1, 4))));
  ASSERT_EQ(msh.elements.size(), 4U);
  EXPECT_DOUBLE_EQ(msh.content("hmx"), 0.5e6) << "in mm";
  EXPECT_DOUBLE_EQ(msh.content("a 'soft' binder"), 0.5e6);
  EXPECT_EQ(msh.of_group("hmx").at(0).entity, 1);
  EXPECT_EQ(msh.of_group("a 'soft' binder").at(0).entity, 2);
  EXPECT_THAT(msh.of_group("side_x_plus").at(0).nodes, ElementsAre(2U, 3U));
  ASSERT_EQ(msh.periodic.size(), 1U);
  const auto& pair = msh.periodic.front();
  EXPECT_EQ(pair.entity, msh.of_group("side_x_plus").at(0).entity);
  EXPECT_EQ(pair.master, msh.of_group("side_x_minus").at(0).entity);
  EXPECT_THAT(pair.nodes, ElementsAre(ElementsAre(2U, 1U), ElementsAre(3U, 4U)));
  EXPECT_THAT(pair.affine, ElementsAre(1, 0, 0, 1e3, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1));
}

TEST(MshText, NamesSurfacesByTheirDirection) {
  EXPECT_EQ(name_of(films::MeshSurface<3>{Beyond::image, {1, 0, -1}, {}}), "side_x_plus_z_minus");
  EXPECT_EQ(name_of(films::MeshSurface<2>{Beyond::wall, {0, -1}, {}}), "wall_y_minus");
}

}  // namespace
}  // namespace breccia
