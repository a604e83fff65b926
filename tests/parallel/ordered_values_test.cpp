#include "breccia/parallel/ordered_values.hpp"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia::parallel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(OrderedValues, OfOneProcessAreItsOwn) {
  const std::vector<double> own = {0.5, 1.5, 2.5, 3.5};
  const auto places = consecutive_places(0, own.size());
  EXPECT_THAT(collect(std::span(own), places, 1, 3), ElementsAre(1.5, 2.5));
  EXPECT_THAT(collect(std::span(own), places, 4, 4), IsEmpty());
}

TEST(OrderedValues, AreFoundByTheirPlaces) {
  const OrderedPlaces places = {4, [](std::size_t value) { return 10 * value + 3; }};
  EXPECT_EQ(places.before(0), 0U);
  EXPECT_EQ(places.before(3), 0U);
  EXPECT_EQ(places.before(4), 1U);
  EXPECT_EQ(places.before(33), 3U);
  EXPECT_EQ(places.before(34), 4U);
  EXPECT_EQ(OrderedPlaces().before(1), 0U) << "no values, no places";
}

TEST(OrderedValues, ComeInPiecesOfWhichTheLastIsShorter) {
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
  for_each_piece(2 * places_of_a_piece + 5,
                 [&](std::size_t begin, std::size_t end) { pieces.emplace_back(begin, end); });
  using Piece = std::pair<std::size_t, std::size_t>;
  EXPECT_THAT(pieces, ElementsAre(Piece{0, places_of_a_piece}, Piece{places_of_a_piece, 2 * places_of_a_piece},
                                  Piece{2 * places_of_a_piece, 2 * places_of_a_piece + 5}));
}

}  // namespace
}  // namespace breccia::parallel
