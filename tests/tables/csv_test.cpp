#include "tables/csv.hpp"

#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "breccia/error.hpp"

#include "io/text_file.hpp"
#include "messages.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double infinity = std::numeric_limits<double>::infinity();

class Csv : public testing::Test {
 protected:
  [[nodiscard]] CsvTable read(std::string_view text, const std::vector<std::string>& text_columns = {}) const {
    return read_csv(directory.written("table.csv", text), text_columns);
  }
  /// The mistakes in a table, without the directory.
  [[nodiscard]] std::string mistakes(std::string_view text) const {
    const auto message = test::message_of<InputError>([&] { static_cast<void>(read(text)); });
    return test::replaced(message, directory.path().string() + "/", "");
  }

  test::TemporaryDirectory directory;
};

TEST_F(Csv, ReadsColumnsByName) {
  const auto table = read("time_s,modulus_Pa\n1e-3,4168.7\ninf,+2\n");
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_THAT(table.names(), ElementsAre("time_s", "modulus_Pa"));
  EXPECT_THAT(table.numbers("time_s"), ElementsAre(1e-3, infinity));
  EXPECT_THAT(table.numbers("modulus_Pa"), ElementsAre(4168.7, 2.0));
}

TEST_F(Csv, ToleratesBlanksCommentsAndOtherLineEnds) {
  const auto table = read("\xEF\xBB\xBF# a comment\r\n\r\n\"x_m\" , y_m\r\n  1 ,\t2\r\n\n# another\n3,4");
  EXPECT_THAT(table.numbers("x_m"), ElementsAre(1.0, 3.0));
  EXPECT_THAT(table.numbers("y_m"), ElementsAre(2.0, 4.0));
  EXPECT_EQ(table.location(1), (directory.path() / "table.csv").string() + ":7");
}

TEST_F(Csv, ReadsTextColumns) {
  const auto table = read("stage,time_s\nHB-1,1\n\"a, \"\"b\"\"\",2\n", {"stage"});
  EXPECT_THAT(table.text("stage"), ElementsAre("HB-1", "a, \"b\""));
  EXPECT_THAT(table.numbers("time_s"), ElementsAre(1.0, 2.0));
}

TEST_F(Csv, ReportsEveryBadLine) {
  EXPECT_EQ(mistakes("a,b\n1,2\n1,x\n1\n,2\nnan,1.5 mm\n"),
            "table.csv:3: b: expected a number, got \"x\"\n"
            "table.csv:4: expected 2 values (a, b), got 1\n"
            "table.csv:5: a: expected a number, got nothing\n"
            "table.csv:6: a: expected a number, got \"nan\"\n"
            "table.csv:6: b: expected a number, got \"1.5 mm\"");
}

TEST_F(Csv, ReportsThreeMistakesOfAKind) {
  std::string text = "a,b\n";
  for (int i = 0; i < 10000; ++i) text += "x,1\n";
  EXPECT_EQ(mistakes(text + "1\n"),
            "table.csv:2: a: expected a number, got \"x\"\n"
            "table.csv:3: a: expected a number, got \"x\"\n"
            "table.csv:4: a: expected a number, got \"x\"\n"
            "table.csv:10002: expected 2 values (a, b), got 1\n"
            "table.csv: ... 9997 more like these: a: expected a number");
}

TEST_F(Csv, ReportsTwentyKindsOfMistakes) {
  std::string names = "c0", values = "x";
  for (int i = 1; i < 30; ++i) {
    names += ",c" + std::to_string(i);
    values += ",x";
  }
  const auto message = mistakes(names + "\n" + values + "\n");
  EXPECT_THAT(message, HasSubstr("table.csv:2: c19: "));
  EXPECT_THAT(message, Not(HasSubstr("c20: ")));
  EXPECT_THAT(message, testing::EndsWith("table.csv: ... 10 more"));
}

TEST_F(Csv, BytesThatCannotBePrintedAreEscaped) {
  EXPECT_EQ(mistakes("a,b\n1,\x1b[2J\n"), "table.csv:2: b: expected a number, got \"\\u001b[2J\"");
  EXPECT_EQ(mistakes("a\n" + std::string(100, 'x') + "\n"),
            "table.csv:2: a: expected a number, got \"" + std::string(60, 'x') + "...\"");
}

TEST_F(Csv, RefusesBinaryFiles) {
  using namespace std::string_literals;
  EXPECT_EQ(mistakes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s),
            "table.csv: expected text, got a binary file, such as a picture");
  EXPECT_EQ(mistakes("PK\x03\x04\x14\0"s),
            "table.csv: expected text, got a workbook of a spreadsheet or an archive; save its table as CSV");
}

TEST_F(Csv, ReadsUtf16OfBothByteOrders) {
  using namespace std::string_literals;
  for (const auto& text : {"\xff\xfe"
                           "a\0\n\0"
                           "1\0\n\0"s,
                           "\xfe\xff\0a\0\n\0"
                           "1\0\n"s,
                           "a\0\n\0"
                           "1\0\n\0"s}) {
    EXPECT_THAT(read(text).numbers("a"), ElementsAre(1.0));
  }
  // U+00B0, U+20AC and U+1D70F as one and as two units.
  const auto table = read(
      "\xff\xfe\xb0\0\xac\x20\x35\xd8\x0f\xdf\n\0"
      "2\0\n\0"s);
  EXPECT_THAT(table.names(), ElementsAre("\u00b0\u20ac\U0001d70f"));
  for (const auto& text : {"\xff\xfe"
                           "a\0\n"s,
                           "\xff\xfe\x35\xd8\n\0"s, "\xff\xfe\x0f\xdf\n\0"s}) {
    EXPECT_EQ(mistakes(text), "table.csv: UTF-16 with half a character; save it as UTF-8");
  }
}

TEST_F(Csv, QuotesStandAroundWholeValues) {
  const auto table = read("stage,a\n\"x\ny\",1\nG\",2\n\"z,3\n", {"stage"});
  EXPECT_THAT(table.text("stage"), ElementsAre("x\ny", "G\"", "\"z"));
  EXPECT_THAT(table.numbers("a"), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_EQ(table.location(1), (directory.path() / "table.csv").string() + ":4");
}

TEST_F(Csv, ReportsBadHeaders) {
  EXPECT_EQ(mistakes(""), "table.csv: expected a header line");
  EXPECT_EQ(mistakes("# only a comment\n"), "table.csv: expected a header line");
  EXPECT_EQ(mistakes("a,a\n1,2\n"), "table.csv:1: two columns are called \"a\"");
  EXPECT_THAT(mistakes("1,2\n3,4\n"),
              HasSubstr("table.csv:1: expected the name of a column (the first line is the header), got \"1\""));
}

TEST_F(Csv, NamesTheColumnsThereAreWhenOneIsMissing) {
  const auto table = read("a,b\n1,2\n");
  EXPECT_TRUE(table.has("a"));
  EXPECT_FALSE(table.has("c"));
  EXPECT_THAT(test::message_of<InputError>([&] { static_cast<void>(table.numbers("c")); }),
              HasSubstr("no column \"c\"; it has \"a\", \"b\""));
}

TEST_F(Csv, AMissingFileIsAFileError) {
  EXPECT_THROW(static_cast<void>(read_csv(directory.path() / "none.csv")), FileError);
}

TEST_F(Csv, RoundTripKeepsEveryBit) {
  const std::vector<double> numbers{std::numbers::pi, 1.0 / 3.0, 5e-324, -1.7976931348623157e308, infinity, 0.1};
  const std::vector<std::string> names{"HB-1", "a,b", "#1", "say \"x\"\r\ny", "", " e "};
  const auto path = directory.path() / "out.csv";
  write_csv(path, {{"stage", names}, {"modulus_Pa", numbers}}, "first\nsecond");
  const auto table = read_csv(path, {"stage"});
  EXPECT_EQ(table.numbers("modulus_Pa"), numbers);
  EXPECT_EQ(table.text("stage"), names);
  EXPECT_TRUE(read_text(path).starts_with("# first\n# second\nstage,modulus_Pa\nHB-1,3.141592653589793\n"));
}

TEST_F(Csv, RefusesToWriteColumnsOfUnequalLength) {
  const std::vector<CsvColumn> columns{{"a", std::vector<double>{1.0}}, {"b", std::vector<double>{}}};
  EXPECT_THROW(write_csv(directory.path() / "out.csv", columns), InputError);
}

}  // namespace
}  // namespace breccia
