#include "breccia/microstructure/cell_faces.hpp"

#include <array>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "microstructure/expect_error.hpp"
#include "microstructure/voronoi_sites_25.hpp"

namespace breccia {
namespace {

/// Cells that are equal squares, n along each side of a periodic box.
Tessellation<2> squares(int n) {
  LaguerreSites<2> sites;
  sites.side = 1.0;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) sites.sites.push_back({{(column + 0.5) / n, (row + 0.5) / n}});
  }
  return Tessellation<2>(sites);
}

TEST(CellFaces, AreAllTakenByAShareOfOne) {
  const auto all = random_faces(squares(4), 1.0, 3);
  EXPECT_EQ(all.faces.size(), 32U) << "two for each square";
  EXPECT_DOUBLE_EQ(all.share, 1.0);
  std::set<std::tuple<std::size_t, std::size_t, Index<2>>> distinct;
  for (const auto& [first, second, image] : all.faces) distinct.emplace(first, second, image);
  EXPECT_EQ(distinct.size(), 32U);
}

TEST(CellFaces, ComeAsCloseToTheirShareAsFacesAllow) {
  const Tessellation<2> tessellation(test::voronoi_sites_25());
  for (const double share : {0.0, 0.1, 0.37, 0.8}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const auto taken = random_faces(tessellation, share, seed);
      EXPECT_NEAR(taken.share, share, 0.02) << "half of the longest of 75 faces";
      EXPECT_EQ(taken.faces.empty(), share == 0.0);
    }
  }
}

TEST(CellFaces, DependOnTheSeedAlone) {
  const auto pairs = [](std::uint64_t seed) {
    std::vector<std::array<std::size_t, 2>> found;
    for (const auto& face : random_faces(squares(5), 0.3, seed).faces) found.push_back({face.first, face.second});
    return found;
  };
  EXPECT_EQ(pairs(7), pairs(7));
  EXPECT_NE(pairs(7), pairs(8));
}

TEST(CellFaces, AcrossADirectionAreTakenFirst) {
  const auto taken = faces_across<2>(squares(4), 0.5, {0.0, -3.0});
  EXPECT_DOUBLE_EQ(taken.share, 0.5);
  ASSERT_EQ(taken.faces.size(), 16U);
  for (const auto& [first, second, image] : taken.faces) EXPECT_EQ(first % 4, second % 4) << "of one column";
}

TEST(CellFaces, OfPairsAreAllFacesBetweenThem) {
  const auto tessellation = squares(2);
  const std::vector<SitePair> pairs = {{{1, 0}}, {{0, 1}}};
  const auto taken = faces_of_pairs<2>(tessellation, pairs);
  EXPECT_EQ(taken.faces.size(), 2U) << "the grains touch across the side of the box, too";
  EXPECT_DOUBLE_EQ(taken.share, 0.25);
  for (const auto& [first, second, image] : taken.faces) {
    const std::vector<SitePair> one = {{{first, second}, {image[0], image[1]}}};
    const std::vector<SitePair> reversed = {{{second, first}, {-image[0], -image[1]}}};
    EXPECT_EQ(faces_of_pairs<2>(tessellation, one).faces.size(), 1U) << name_of(one[0]);
    EXPECT_EQ(faces_of_pairs<2>(tessellation, reversed).faces.size(), 1U) << name_of(reversed[0]);
  }
}

TEST(CellFaces, OfPairsThatDoNotTouchAreRefused) {
  const auto tessellation = squares(4);
  const std::vector<SitePair> pairs = {{{0, 1}}, {{0, 5}}, {{0, 1}, {1, 0}}, {{0, 99}}};
  test::expect_error<InputError>([&] { static_cast<void>(faces_of_pairs<2>(tessellation, pairs)); },
                                 "the 16 grains have numbers from 0 to 15, got 0-99",
                                 "no film is between the grains 0-5, 0-1:1,0");
}

TEST(CellFaces, RefuseSharesAndDirectionsThatAreNone) {
  const auto tessellation = squares(2);
  test::expect_error<InputError>([&] { static_cast<void>(random_faces(tessellation, 1.2, 1)); },
                                 "from 0 to 1, got 1.2");
  test::expect_error<InputError>(
      [&] {
        static_cast<void>(faces_across<2>(tessellation, 0.5, {0.0, 0.0}));
      },
      "a direction with a length");
}

}  // namespace
}  // namespace breccia
