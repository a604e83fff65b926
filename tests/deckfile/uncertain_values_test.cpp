#include <cmath>
#include <string>
#include <string_view>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "deckfile/deck.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class UncertainValues : public testing::Test {
 protected:
  [[nodiscard]] Deck read(std::string_view text) const { return Deck(directory.written("deck.toml", text)); }
  /// The mistakes in a deck whose modulus, number, share and count are read.
  [[nodiscard]] std::string mistakes(std::string_view text) const {
    const auto deck = read(text);
    const auto root = deck.root();
    static_cast<void>(root.optional_quantity("modulus", Dimension::pressure, Range::positive()));
    static_cast<void>(root.optional_number("number", Range::positive()));
    if (root.has("share")) static_cast<void>(root.fraction("share"));
    static_cast<void>(root.optional_integer("count", Range::positive()));
    return test::replaced(test::message_of<InputError>([&] { deck.finish(); }), directory.path().string() + "/", "");
  }

  test::TemporaryDirectory directory;
};

TEST_F(UncertainValues, AGetterReturnsTheMedianOfADistribution) {
  const auto deck = read(R"(
modulus = { value = "5.8 GPa", sd = "600 MPa" }
number = { value = 2, factor = 3 }
other = { from = 1, to = 100, scale = "logarithmic" }
share = { value = "70 %", sd = 0.01 }
cold = { value = "20 degC", sd = "2 K" }
)");
  const auto root = deck.root();
  EXPECT_DOUBLE_EQ(root.quantity("modulus", Dimension::pressure, Range::positive()), 5.8e9);
  EXPECT_DOUBLE_EQ(root.number("number"), 2.0);
  EXPECT_DOUBLE_EQ(root.number("other"), 10.0);
  EXPECT_DOUBLE_EQ(root.fraction("share"), 0.7);
  EXPECT_DOUBLE_EQ(root.quantity("cold", Dimension::temperature), 293.15);
  EXPECT_NO_THROW(deck.finish());
  const auto& inputs = deck.uncertain_inputs();
  ASSERT_THAT(inputs, SizeIs(5));
  EXPECT_EQ(inputs[0].name, "modulus");
  EXPECT_EQ(inputs[0].unit, "Pa");
  EXPECT_DOUBLE_EQ(std::get<Normal>(std::get<Distribution>(inputs[0].known)).deviation, 600e6);
  EXPECT_EQ(inputs[1].unit, "");
  EXPECT_TRUE(std::holds_alternative<LogUniform>(std::get<Distribution>(inputs[2].known)));
  EXPECT_DOUBLE_EQ(std::get<Normal>(std::get<Distribution>(inputs[4].known)).deviation, 2.0)
      << "a difference of temperatures, not a temperature";
}

TEST_F(UncertainValues, AValueMayBeOneOfSeveral) {
  directory.write("a.csv", "");
  directory.write("b.csv", "");
  const auto deck = read(R"(
count = { any = [3, 4] }
text = { any = ["b", "a"] }
file = { any = ["b.csv", "a.csv"] }
modulus = { any = ["1 GPa", "2 GPa"] }
)");
  const auto root = deck.root();
  EXPECT_EQ(root.integer("count"), 3);
  EXPECT_EQ(root.integer("count"), 3) << "read twice, an input once";
  EXPECT_EQ(root.text("text"), "b");
  EXPECT_EQ(root.file("file").filename(), "b.csv");
  EXPECT_DOUBLE_EQ(root.quantity("modulus", Dimension::pressure), 1e9);
  EXPECT_NO_THROW(deck.finish());
  ASSERT_THAT(deck.uncertain_inputs(), SizeIs(4));
  EXPECT_THAT(std::get<Choices>(deck.uncertain_inputs()[1].known).values, ElementsAre("b", "a"));
}

TEST_F(UncertainValues, ACertainValueIsNoInput) {
  const auto deck = read("number = 1\n");
  EXPECT_DOUBLE_EQ(deck.root().number("number"), 1.0);
  EXPECT_THAT(deck.uncertain_inputs(), IsEmpty());
}

TEST_F(UncertainValues, AValueAtACoordinateIsReadBackAsItIs) {
  const UncertainInput input = {"modulus", "Pa", Distribution(Normal{5.8e9, 0.6e9})};
  for (const double score : {-3.0, 0.0, 0.1234, 2.0}) {
    const auto text = std::get<std::string>(value_at(input, score));
    EXPECT_EQ(parse_quantity(text, Dimension::pressure), 5.8e9 + 0.6e9 * score);
  }
  EXPECT_EQ(std::get<double>(value_at({"number", "", Distribution(Uniform{1.0, 3.0})}, 0.0)), 2.0);
  const UncertainInput choices = {"seed", "", Choices{{std::int64_t{7}, std::int64_t{8}}}};
  EXPECT_EQ(choices_of(choices), 2U);
  EXPECT_EQ(std::get<std::int64_t>(value_at(choices, 1.0)), 8);
}

TEST_F(UncertainValues, ReportsMistakes) {
  EXPECT_THAT(mistakes(R"(modulus = { value = "1 GPa" })"),
              HasSubstr("modulus: expected exactly one of sd, factor, to"));
  EXPECT_THAT(mistakes(R"(modulus = { value = "1 GPa", sd = "0.5 GPa" })"),
              HasSubstr("modulus.sd: expected less than a quarter of the distance to the values that are not allowed"));
  EXPECT_THAT(mistakes(R"(modulus = { value = "1 GPa", sd = 0.1 })"), HasSubstr("modulus.sd: expected a pressure"));
  EXPECT_THAT(mistakes(R"(modulus = { value = 1, sd = "0.1 GPa" })"), HasSubstr("modulus.value: expected a pressure"));
  EXPECT_THAT(mistakes(R"(modulus = { sd = "0.1 GPa" })"), HasSubstr("modulus.value: missing"));
  EXPECT_THAT(mistakes("number = { value = 1, factor = 0.5 }"), HasSubstr("number.factor: expected a factor above 1"));
  EXPECT_THAT(mistakes("number = { from = 3, to = 1 }"),
              HasSubstr("number.to: expected two rising values, got 3 and 1"));
  EXPECT_THAT(mistakes(R"(share = { from = 0, to = 0.5, scale = "logarithmic" })"),
              HasSubstr("share.to: expected positive values of a logarithmic range, got 0"));
  EXPECT_THAT(mistakes(R"(number = { from = 1, to = 3, scale = "log" })"), HasSubstr("number.scale: expected one of"));
  EXPECT_THAT(mistakes("number = { value = 1, sd = 0.1, width = 3 }"), HasSubstr(R"(number: unknown key "width")"));
  EXPECT_THAT(mistakes("number = { value = { value = 1, sd = 0.1 }, sd = 0.1 }"),
              HasSubstr("number.value: expected a number, not a distribution within a distribution"));
  EXPECT_THAT(mistakes("share = { value = 0.5, factor = 2 }"),
              HasSubstr("share.factor: expected sd, or from and to, of a number that has a largest value"));
  EXPECT_THAT(mistakes("share = { value = 0.98, sd = 0.01 }"), HasSubstr("share.sd: expected less than a quarter"));
  EXPECT_THAT(mistakes("count = { value = 3, sd = 1 }"), HasSubstr("count: expected a positive integer, got a table"));
  EXPECT_THAT(mistakes("count = { any = [] }"), HasSubstr("count.any: expected an array of two values or more"));
  EXPECT_THAT(mistakes("count = { any = 3 }"), HasSubstr("count.any: expected an array of two values or more"));
  EXPECT_THAT(mistakes("count = { any = [-1, 2] }"), HasSubstr("count: expected a positive integer, got -1"));
}

}  // namespace
}  // namespace breccia
