// Tests of the bonds of films in the deck.

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "decks.hpp"
#include "study/identity.hpp"

namespace breccia {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class FilmBondsOfADeck : public testing::Test {
 protected:
  /// A deck with a stage of grains that has these lines, and with these lines of the tests.
  [[nodiscard]] static std::string deck(std::string_view stage, std::string_view tests = "model = \"films\"\n") {
    return test::join(test::materials,
                      "[[stages]]\nname = \"a\"\nmatrix = \"binder\"\nbox = \"1 mm\"\n"
                      "filler = { material = \"hmx\", fraction = 0.93, sizes = { diameter = \"0.1 mm\" } }\n",
                      stage, test::tests, tests);
  }
  [[nodiscard]] static std::string with(std::string_view bonds) {
    return deck(test::join("packing = { method = \"laguerre\", seed = 7 }\nbonds = { ", bonds, " }\n"));
  }
  [[nodiscard]] FilmBonds bonds(std::string_view text) const {
    return directory.study(with(text)).stages.at(0).bonds.value();
  }
  [[nodiscard]] std::string mistakes(std::string_view text) const { return directory.mistakes(with(text)); }

  test::DeckDirectory directory;
};

TEST_F(FilmBondsOfADeck, AreAShareOfTheFilms) {
  const auto open = bonds(R"(debonded = 0.1, kind = "open")");
  EXPECT_EQ(open.debonded, 0.1);
  EXPECT_EQ(open.kind, Debonding::open);
  EXPECT_FALSE(open.seed) << "that of the packing";
  const auto sealed = bonds(R"(debonded = "35 %", kind = "sealed", seed = 3)");
  EXPECT_EQ(sealed.debonded, 0.35);
  EXPECT_EQ(sealed.kind, Debonding::sealed);
  EXPECT_EQ(sealed.seed, 3U);
  EXPECT_EQ(bonds(R"(debonded = 1, kind = "slip")").kind, Debonding::slip);
}

TEST_F(FilmBondsOfADeck, AreSprings) {
  const auto springs =
      bonds(R"(debonded = 1, kind = "spring", normal_stiffness = "2 GPa/um", tangential_stiffness = "0.3 GPa/mm")");
  EXPECT_EQ(springs.kind, Debonding::spring);
  EXPECT_EQ(springs.springs.normal, 2e15);
  EXPECT_EQ(springs.springs.tangential, 3e11);
}

TEST_F(FilmBondsOfADeck, RefuseSpringsThatAreNone) {
  EXPECT_THAT(mistakes(R"(debonded = 1, kind = "spring", normal_stiffness = "2 GPa/um")"),
              HasSubstr("bonds.tangential_stiffness: missing, expected a stiffness of an interface"));
  EXPECT_THAT(
      mistakes(R"(debonded = 1, kind = "spring", normal_stiffness = "2 GPa", tangential_stiffness = "0 GPa/um")"),
      AllOf(HasSubstr(R"(bonds.normal_stiffness: expected a stiffness of an interface)"), HasSubstr(R"("2 GPa")"),
            HasSubstr("bonds.tangential_stiffness: expected a stiffness of an interface from")));
  EXPECT_THAT(mistakes("debonded = 1, kind = \"spring\", normal_stiffness = \"1e30 Pa/m\", "
                       "tangential_stiffness = \"1 GPa/um\""),
              HasSubstr("1e30 Pa/m"));
  EXPECT_THAT(mistakes(R"(debonded = 1, kind = "open", normal_stiffness = "2 GPa/um")"),
              HasSubstr(R"(bonds.normal_stiffness: kind = "spring" alone has springs)"));
}

TEST_F(FilmBondsOfADeck, AreThoseAcrossADirection) {
  EXPECT_THAT(bonds(R"(debonded = 0.1, kind = "open", normal = [0, 1])").normal, ElementsAre(0.0, 1.0));
}

TEST_F(FilmBondsOfADeck, AreListed) {
  const auto films = bonds(R"(films = ["3-17", "0-4:0,-1"], kind = "open")").films;
  ASSERT_EQ(films.size(), 2U);
  EXPECT_EQ(name_of(films[0]), "3-17");
  EXPECT_EQ(name_of(films[1]), "0-4:0,-1");
}

TEST_F(FilmBondsOfADeck, AreNoneWhereNothingIsDebonded) {
  EXPECT_FALSE(directory.study(with(R"(debonded = 0, kind = "open")")).stages.at(0).bonds);
}

TEST_F(FilmBondsOfADeck, AreAPartOfTheIdentityOfAStudy) {
  const auto identity = [this](const std::string& text) { return content_of(directory.study(text)); };
  const auto bonded = identity(deck("packing = { method = \"laguerre\", seed = 7 }\n"));
  const auto open = identity(with(R"(debonded = 0.1, kind = "open")"));
  EXPECT_NE(bonded, open);
  EXPECT_NE(open, identity(with(R"(debonded = 0.1, kind = "sealed")")));
  EXPECT_NE(open, identity(with(R"(debonded = 0.1, kind = "open", seed = 7)")));
  const auto springs = [&](int normal, int tangential) {
    return identity(with(fmt::format(
        R"(debonded = 0.1, kind = "spring", normal_stiffness = "{} Pa/m", tangential_stiffness = "{} Pa/m")", normal,
        tangential)));
  };
  EXPECT_NE(springs(1, 1), springs(1, 2));
  EXPECT_NE(springs(1, 1), springs(2, 1));
}

TEST_F(FilmBondsOfADeck, RefuseWhatIsMissingOrNone) {
  EXPECT_THAT(mistakes("debonded = 0.1"),
              HasSubstr(R"(bonds.kind: missing, expected one of "open", "sealed", "slip", "spring")"));
  EXPECT_THAT(mistakes(R"(debonded = 0.1, kind = "closed")"), HasSubstr(R"("open", "sealed", "slip", "spring")"));
  EXPECT_THAT(mistakes(R"(kind = "open")"), HasSubstr("debonded"));
  EXPECT_THAT(mistakes(R"(debonded = -0.1, kind = "open")"),
              HasSubstr("a number from 0 to 1, or per cent as in \"35 %\", got -0.1"));
  EXPECT_THAT(mistakes(R"(debonded = 10, kind = "open")"),
              HasSubstr("from 0 to 1, or per cent as in \"35 %\", got 10"));
  EXPECT_THAT(mistakes(R"(debonded = "10", kind = "open")"), HasSubstr("or per cent as in"));
  EXPECT_THAT(mistakes(R"(debond = 0.1, kind = "open")"), HasSubstr("debonded"));
}

TEST_F(FilmBondsOfADeck, RefuseTwoReadings) {
  EXPECT_THAT(mistakes(R"(debonded = 0.1, films = ["0-1"], kind = "open")"), HasSubstr("debonded"));
  EXPECT_THAT(mistakes(R"(films = ["0-1"], seed = 2, normal = [0, 1], kind = "open")"),
              AllOf(HasSubstr("bonds.seed: the films are listed"), HasSubstr("bonds.normal: the films are listed")));
  EXPECT_THAT(mistakes(R"(debonded = 0.1, normal = [0, 1], seed = 2, kind = "open")"),
              HasSubstr("the films follow from the normal"));
}

TEST_F(FilmBondsOfADeck, RefusePairsAndNormalsThatAreNone) {
  EXPECT_THAT(mistakes(R"(films = [], kind = "open")"), HasSubstr("expected at least one"));
  EXPECT_THAT(mistakes(R"(films = ["3:4", 7, "5-", "1-2:0", "1-2x"], kind = "open")"),
              AllOf(HasSubstr(R"("3:4")"), HasSubstr("got 7"), HasSubstr(R"("5-")"), HasSubstr(R"("1-2:0")"),
                    HasSubstr(R"("1-2x")")));
  EXPECT_THAT(mistakes(R"(debonded = 0.1, normal = [0, 0, 1], kind = "open")"),
              HasSubstr("expected 2 components, one for each dimension, got 3"));
  EXPECT_THAT(mistakes(R"(debonded = 0.1, normal = [0, 0], kind = "open")"), HasSubstr("not all zero"));
}

TEST_F(FilmBondsOfADeck, BelongToFilmsOfAPeriodicBox) {
  const std::string open = "bonds = { debonded = 0.1, kind = \"open\" }\n";
  EXPECT_THAT(directory.mistakes(deck("cells = 300\npacking = { method = \"laguerre\" }\n" + open, "")),
              HasSubstr(R"(expected tests.model = "films")"));
  EXPECT_THAT(directory.mistakes(deck("packing = { method = \"laguerre\", walls = \"cut\" }\n" + open)),
              HasSubstr("films of a window are all bonded"));
  EXPECT_THAT(
      directory.mistakes(deck("packing = { method = \"laguerre\" }\nbonds = { debonded = 0.1, kind = \"slip\" }\n",
                              "model = \"films\"\nfilms = { layers = 2 }\n")),
      HasSubstr("debonded as open gaps alone"));
}

}  // namespace
}  // namespace breccia
