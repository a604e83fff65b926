#include <fstream>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include "breccia/error.hpp"
#include "breccia/tables/measured_table_reader.hpp"

#include "messages.hpp"
#include "tables/table_description.hpp"
#include "temporary_directory.hpp"

namespace breccia {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// A sheet of a workbook that a test writes: the content of its element sheetData.
struct WrittenSheet {
  std::string name;
  std::string rows;
  std::string state = "visible";
};

std::string part(std::string_view root, std::string_view content) {
  return fmt::format(R"(<?xml version="1.0"?><{0} xmlns:r="http://example.invalid/relationships">{1}</{0}>)", root,
                     content);
}

/// A relation to another part, of a kind such as "worksheet".
std::string relation(std::string_view identity, std::string_view kind, std::string_view target) {
  return fmt::format(R"(<Relationship Id="{}" Type="http://example.invalid/{}" Target="{}"/>)", identity, kind, target);
}

/// A row of cells that hold numbers, from column A on.
std::string row(int number, std::initializer_list<double> values) {
  std::string cells;
  char column = 'A';
  for (const double value : values) cells += fmt::format(R"(<c r="{}{}"><v>{}</v></c>)", column++, number, value);
  return fmt::format(R"(<row r="{}">{}</row>)", number, cells);
}

std::string text(std::string_view reference, std::string_view value) {
  return fmt::format(R"(<c r="{}" t="inlineStr"><is><t>{}</t></is></c>)", reference, value);
}

/// The names of a creep test, in row 1.
std::string names() {
  return fmt::format(R"(<row r="1">{}{}</row>)", text("A1", "time_s"), text("B1", "shear_compliance_1_per_MPa"));
}

class Workbook : public testing::Test {
 protected:
  /// Writes a workbook: sheets and, where a test needs them, styles and shared texts.
  [[nodiscard]] std::filesystem::path written(const std::vector<WrittenSheet>& sheets,
                                              std::map<std::string, std::string> parts = {}) const {
    std::string list, relations;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      const auto& [name, rows, state] = sheets[i];
      list += fmt::format(R"(<sheet name="{}" sheetId="{}" r:id="r{}" state="{}"/>)", name, i + 1, i, state);
      relations += relation(fmt::format("r{}", i), "worksheet", fmt::format("worksheets/sheet{}.xml", i));
      parts[fmt::format("xl/worksheets/sheet{}.xml", i)] =
          part("worksheet", fmt::format("<sheetData>{}</sheetData>", rows));
    }
    parts["xl/workbook.xml"] = part("workbook", fmt::format("<sheets>{}</sheets>", list));
    if (parts.contains("xl/styles.xml")) relations += relation("styles", "styles", "styles.xml");
    if (parts.contains("xl/texts.xml")) relations += relation("texts", "sharedStrings", "/xl/texts.xml");
    parts["xl/_rels/workbook.xml.rels"] = part("Relationships", relations);
    parts["_rels/.rels"] = part("Relationships", relation("book", "officeDocument", "./xl/workbook.xml"));
    return archive_of(parts);
  }

  [[nodiscard]] std::filesystem::path archive_of(const std::map<std::string, std::string>& parts) const {
    auto path = directory.path() / "table.xlsx";
    auto* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    for (const auto& [name, content] : parts) {
      auto* source = zip_source_buffer(archive, content.data(), content.size(), 0);
      EXPECT_GE(zip_file_add(archive, name.c_str(), source, ZIP_FL_OVERWRITE), 0);
    }
    EXPECT_EQ(zip_close(archive), 0);
    return path;
  }

  [[nodiscard]] std::string mistakes(const std::filesystem::path& path) const {
    const auto message = test::message_of<InputError>([&] { static_cast<void>(read_measured_table(path)); });
    return test::replaced(message, directory.path().string() + "/", "");
  }

  test::TemporaryDirectory directory;
};

TEST_F(Workbook, IsReadWithTheNumbersOfItsRows) {
  const auto table = read_measured_table(written({{"Creep", names() + row(2, {1.0, 0.25}) + row(5, {10.0, 0.5})}}));
  EXPECT_THAT(table.column(Quantity::time).values, ElementsAre(1.0, 10.0));
  EXPECT_THAT(table.column(Quantity::compliance, ModulusKind::shear).values, ElementsAre(0.25e-6, 0.5e-6));
  EXPECT_THAT(table.location(1), testing::EndsWith("table.xlsx:Creep:5"));
  EXPECT_THAT(description_of(table), HasSubstr("table.xlsx: 2 rows, sheet \"Creep\", names in row 1\n"));
}

TEST_F(Workbook, TextsAreSharedOrInPartsAndNamesMayHaveLineBreaks) {
  const auto shared = part("sst",
                           "<si><t>Time_x000D_\n[min]</t></si>"
                           "<si><r><t>Storage</t></r><r><t xml:space=\"preserve\"> </t></r><r><rPr/>"
                           "<t>modulus [MPa]</t></r><rPh><t>no</t></rPh></si>"
                           "<si><t>E\" [MPa]</t></si><si><t>\"remark\"\tof one</t></si>");
  const auto cell = [](std::string_view reference, int index) {
    return fmt::format(R"(<c r="{}" t="s"><v>{}</v></c>)", reference, index);
  };
  const auto rows = "<row>" + cell("B1", 0) + cell("C1", 1) + cell("D1", 2) + cell("F1", 3) + "</row>" +
                    "<row><c r=\"B2\"><v>2</v></c><c><v>1.5E-3</v></c><c><v>2</v></c></row>";
  const auto table = read_measured_table(written({{"DMA", rows}}, {{"xl/texts.xml", shared}}));
  EXPECT_THAT(table.names(),
              ElementsAre("", "Time  [min]", "Storage modulus [MPa]", "E\" [MPa]", "", "\"remark\" of one"));
  EXPECT_THAT(table.column(Quantity::time).values, ElementsAre(120.0));
  EXPECT_THAT(table.column(Quantity::storage_modulus, ModulusKind::unspecified).values, ElementsAre(1500.0));
  EXPECT_THAT(table.column(Quantity::loss_modulus, ModulusKind::young).values, ElementsAre(2e6));
}

TEST_F(Workbook, TheOneVisibleSheetWithATableIsTaken) {
  const auto data = names() + row(2, {1.0, 0.25});
  const auto remarks = fmt::format("<row>{}</row>", text("A1", "measured on a Monday"));
  const auto table = read_measured_table(written({{"Notes", remarks}, {"Old", data, "hidden"}, {"New", data}}));
  EXPECT_EQ(table.reading().sheet, "New");
  EXPECT_EQ(mistakes(written({{"One", data}, {"Two", data}})),
            "table.xlsx: the sheets \"One\", \"Two\" have a table each; hide the others, or save the one that is meant "
            "as CSV");
  EXPECT_EQ(mistakes(written({{"Notes", remarks}, {"More", remarks}, {"Empty", ""}})),
            "table.xlsx: none of the sheets \"Notes\", \"More\" has a line with the names of two known columns");
  EXPECT_EQ(mistakes(written({{"Empty", ""}, {"Hidden", data, "veryHidden"}})),
            "table.xlsx: no visible sheet of the workbook has values");
}

TEST_F(Workbook, AChosenColumnMarksItsSheet) {
  const auto odd =
      fmt::format(R"(<row>{}{}</row>)", text("A1", "a [s]"), text("B1", "b [1/MPa]")) + row(2, {1.0, 0.25});
  const auto remarks = fmt::format("<row>{}</row>", text("A1", "measured on a Monday"));
  const std::vector<ColumnChoice> choices{{Quantity::time, "a [s]"}, {Quantity::compliance, "b [1/MPa]"}};
  EXPECT_EQ(read_measured_table(written({{"Notes", remarks}, {"Data", odd}}), choices).reading().sheet, "Data");
}

TEST_F(Workbook, ShownNumbersThatAreNotTheStoredOnesAreRefused) {
  const auto styles = part(
      "styleSheet",
      R"(<numFmts><numFmt numFmtId="164" formatCode="[h]:mm"/>)"
      R"(<numFmt numFmtId="165" formatCode="0.0&quot; s&quot;\d"/>)"
      R"(<numFmt numFmtId="166" formatCode="[Red]0.00%"/><numFmt numFmtId="167" formatCode="[&lt;1000]0.0;#,##0,.0"/>)"
      R"(<numFmt numFmtId="168" formatCode="#,##0.0"/></numFmts>)"
      R"(<cellXfs><xf numFmtId="0"/><xf numFmtId="21"/><xf numFmtId="164"/>)"
      R"(<xf numFmtId="165"/><xf numFmtId="166"/><xf numFmtId="11"/><xf numFmtId="167"/>)"
      R"(<xf numFmtId="168"/></cellXfs>)");
  std::string rows = names();
  for (int style = 0; style < 8; ++style) {
    rows += fmt::format(R"(<row><c s="{}"><v>0.5</v></c><c><v>1</v></c></row>)", style);
  }
  const auto message = mistakes(written({{"Creep", rows}}, {{"xl/styles.xml", styles}}));
  EXPECT_EQ(message,
            "table.xlsx:Creep:3: time_s: expected a number, got \"0.5 days, shown as a date or time\" (write it in the "
            "unit of the column, as a number; a day has 86400 s)\n"
            "table.xlsx:Creep:4: time_s: expected a number, got \"0.5 days, shown as a date or time\" (write it in the "
            "unit of the column, as a number; a day has 86400 s)\n"
            "table.xlsx:Creep:6: time_s: expected a number, got \"0.5 stored, shown as a percentage\" (write the "
            "number that is meant, in a format that shows it as it is)\n"
            "table.xlsx: ... 1 more like these: time_s: expected a number");
  const auto scaled = names() + R"(<row><c s="6"><v>0.5</v></c><c s="7"><v>1</v></c></row>)";
  EXPECT_EQ(mistakes(written({{"Creep", scaled}}, {{"xl/styles.xml", styles}})),
            "table.xlsx:Creep:2: time_s: expected a number, got \"0.5 stored, shown in thousands\" (write the number "
            "that is meant, in a format that shows it as it is)");
  const auto beyond = names() + R"(<row><c s="8"><v>0.5</v></c><c><v>1</v></c></row>)";
  EXPECT_THAT(mistakes(written({{"Creep", beyond}}, {{"xl/styles.xml", styles}})),
              HasSubstr("a style that is not stored"));
}

TEST_F(Workbook, FormulasHaveTheirStoredValueAndErrorsOfCellsAreNoComments) {
  const auto rows = names() + R"(<row><c><f>1+1</f><v>2</v></c><c t="str"><f>B1</f><v>0.5</v></c></row>)";
  EXPECT_THAT(read_measured_table(written({{"Creep", rows}})).column(Quantity::time).values, ElementsAre(2.0));
  const auto broken = names() + R"(<row><c><f>A1</f><v></v></c><c><v>1</v></c></row>)"
                                R"(<row><c t="e"><v>#DIV/0!</v></c><c t="b"><v>1</v></c></row>)"
                                R"(<row><c t="d"><v>2026-01-01</v></c></row>)";
  EXPECT_EQ(
      mistakes(written({{"Creep", broken}})),
      "table.xlsx:Creep:2: time_s: expected a number, got \"a formula without its value; save it in a spreadsheet\"\n"
      "table.xlsx:Creep:3: time_s: expected a number, got \"#DIV/0!\"\n"
      "table.xlsx:Creep:3: shear_compliance_1_per_MPa: expected a number, got \"TRUE\"\n"
      "table.xlsx:Creep:4: time_s: expected a number, got \"2026-01-01 stored as a date\"\n"
      "table.xlsx:Creep:4: shear_compliance_1_per_MPa: expected a number, got nothing");
}

TEST_F(Workbook, NoTextOfACellChangesHowTheOthersAreRead) {
  const auto head = fmt::format(R"(<row r="1">{}</row><row r="2">{}{}{}</row>)",
                                text("A1", "Time, temperature, storage modulus and loss modulus of A"), text("A2", "#"),
                                text("B2", "time_s"), text("C2", "modulus_Pa"));
  std::string rows = head;
  for (int number = 3; number < 6; ++number) {
    rows += fmt::format(R"(<row r="{0}">{1}<c r="B{0}"><v>{0}</v></c><c r="C{0}"><v>{2}</v></c>{3}</row>)", number,
                        text(fmt::format("A{}", number), fmt::format("#{}", number)), 10 - number,
                        text(fmt::format("D{}", number), "\"first run"));
  }
  const auto notes = fmt::format("<row>{}</row>", text("A1", "1,000 samples"));
  const auto table = read_measured_table(written({{"Notes", notes}, {"Data", rows}}));
  EXPECT_THAT(table.column(Quantity::time).values, ElementsAre(3.0, 4.0, 5.0));
  EXPECT_THAT(table.column(Quantity::modulus).values, ElementsAre(7.0, 6.0, 5.0));
}

TEST_F(Workbook, WhatIsThereTwiceOrElsewhereIsRefused) {
  const auto refused = [&](const std::string& row, const std::string& reason) {
    EXPECT_THAT(mistakes(written({{"Creep", names() + row}})), HasSubstr(reason)) << row;
  };
  const std::string one = R"(<row r="2"><c r="A2"><v>1</v></c><c r="B2"><v>2</v></c></row>)";
  refused(one + one, "row 2 is in the workbook twice");
  refused(R"(<row r="2"><c r="A2"><v>1</v></c><c r="A2"><v>3</v></c></row>)", "the cell \"A2\" twice");
  refused(R"(<row r="2"><c r="A3"><v>1</v></c></row>)", "row 2 of the workbook has a cell \"A3\"");
  refused(R"(<row r="0"><c><v>1</v></c></row>)", "out of range");
  refused(R"(<row r="2"><c t="zz"><v>1</v></c></row>)", "a cell of the type \"zz\"");
  // Two rows at both ends of a sheet with cells in the last column take no memory for what is between them.
  std::string wide = names();
  for (int row = 2; row < 1100; ++row) wide += fmt::format(R"(<row r="{0}"><c r="XFD{0}"><v>1</v></c></row>)", row);
  EXPECT_THAT(mistakes(written({{"Creep", wide}})), HasSubstr("a sheet of 1099 rows and 16384 columns is too large"));
}

TEST_F(Workbook, PartsThatAreMissingAreRefused) {
  const std::map<std::string, std::string> parts = {
      {"_rels/.rels", part("Relationships", relation("b", "officeDocument", "/book.xml"))},
      {"book.xml", part("workbook", R"(<sheets><sheet name="A" r:id="a"/></sheets>)")},
      {"_rels/book.xml.rels", part("Relationships", relation("a", "worksheet", "a.xml"))}};
  EXPECT_EQ(mistakes(archive_of(parts)), "table.xlsx: the workbook lacks the part \"a.xml\"");
}

TEST_F(Workbook, OtherAndDamagedArchivesAreRefused) {
  EXPECT_EQ(mistakes(archive_of({{"mimetype", "application/vnd.oasis.opendocument.spreadsheet"}})),
            "table.xlsx: expected text or a workbook in the format .xlsx, got another archive; save the table as CSV");
  EXPECT_THAT(mistakes(directory.written("table.xlsx", "PK\x03\x04 and no more")),
              StartsWith("table.xlsx: a damaged archive ("));
  EXPECT_THAT(mistakes(written({{"Creep", names() + "<row"}})),
              StartsWith("table.xlsx: xl/worksheets/sheet0.xml in the workbook is damaged XML: "));
  EXPECT_THAT(mistakes(written({{"Creep", R"(<row><c t="s"><v>7</v></c></row>)"}})),
              HasSubstr("a text that is not stored in it"));
  EXPECT_THAT(mistakes(written({{"Creep", R"(<row><c r="XFE1"><v>7</v></c></row>)"}})),
              HasSubstr("row 1 of the workbook has a cell \"XFE1\""));
  EXPECT_THAT(mistakes(written({{"Creep", R"(<row r="1048577"><c><v>7</v></c></row>)"}})), HasSubstr("out of range"));
  EXPECT_EQ(
      mistakes(directory.written("table.xls", "\xD0\xCF\x11\xE0")),
      "table.xls: expected text, got a document of an old format (.xls) or with a password; save its table as CSV, "
      "or in the format .xlsx without a password");
}

TEST_F(Workbook, ADamagedEntryIsFoundByItsChecksum) {
  const auto path = written({{"Creep", names() + row(2, {1.0, 0.25})}});
  // The same archive without compression, with one digit changed.
  auto* archive = zip_open(path.c_str(), 0, nullptr);
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive, 0); ++i) {
    zip_set_file_compression(archive, static_cast<zip_uint64_t>(i), ZIP_CM_STORE, 0);
  }
  ASSERT_EQ(zip_close(archive), 0);
  std::ifstream file(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const auto at = bytes.find("0.25");
  ASSERT_NE(at, std::string::npos);
  bytes[at + 3] = '7';
  EXPECT_THAT(mistakes(directory.written("table.xlsx", bytes)),
              StartsWith("table.xlsx: xl/worksheets/sheet0.xml in the archive cannot be read: "));
}

}  // namespace
}  // namespace breccia
