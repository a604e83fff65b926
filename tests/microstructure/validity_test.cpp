#include "breccia/microstructure/validity.hpp"

#include <gmock/gmock.h>

#include "breccia/error.hpp"

#include "expect_error.hpp"

namespace breccia {
namespace {

using test::expect_error;

TEST(Validity, AcceptsDiscsThatTouch) {
  EXPECT_NO_THROW(require_valid<2>({3.0, Walls::hard, {{{0.5, 0.5}, 1.0}, {{1.5, 0.5}, 1.0}, {{2.0, 2.0}, 2.0}}}));
  EXPECT_NO_THROW(require_valid<2>({3.0, Walls::hard, {}}));
}

TEST(Validity, ListsEveryDiscThatCannotBe) {
  const Microstructure<2> discs{
      10.0, Walls::hard, {{{5.0, 5.0}, -1.0}, {{12.0, 5.0}, 1.0}, {{9.8, 5.0}, 1.0}, {{5.0, 5.0}, 1.0}}};
  expect_error<InputError>([&] { require_valid(discs); }, "disc 1 ", "positive", "disc 2 ", "outside the box",
                           "disc 3 ", "crosses a wall by 0.3 m");
}

TEST(Validity, ListsEveryPairThatOverlaps) {
  const Microstructure<2> discs{10.0, Walls::hard, {{{2.0, 2.0}, 2.0}, {{3.5, 2.0}, 2.0}, {{5.4, 2.0}, 2.0}}};
  expect_error<InputError>([&] { require_valid(discs); }, "disc 1 ", "overlap by 0.5 m", "disc 3 ", "overlap by 0.1 m");
}

TEST(Validity, SeesOverlapsAcrossPeriodicSides) {
  Microstructure<2> discs{10.0, Walls::periodic, {{{0.5, 0.5}, 2.0}, {{9.5, 9.5}, 2.0}}};
  expect_error<InputError>([&] { require_valid(discs); }, "disc 1 ", "disc 2 ", "overlap by 0.586 m");
  discs.particles[1].centre = {8.5, 0.5};
  EXPECT_NO_THROW(require_valid(discs));
  discs.particles = {{{5.0, 5.0}, 10.5}};
  expect_error<InputError>([&] { require_valid(discs); }, "its own periodic image");
}

TEST(Validity, LongListsAreCut) {
  Microstructure<2> discs{10.0, Walls::hard, {}};
  for (int k = 0; k < 25; ++k) discs.particles.push_back({{11.0, 0.3 * k}, 0.1});
  expect_error<InputError>([&] { require_valid(discs); }, "disc 20 ", "and 5 more");
}

TEST(Validity, BadBox) {
  expect_error<InputError>([] { require_valid<2>({0.0, Walls::hard, {}}); }, "side of the box", "0 m");
}

}  // namespace
}  // namespace breccia
