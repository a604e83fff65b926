// A workbook with one sheet: the parts of its sheet, shared texts and styles, parted by lines of "=====".

#include <map>
#include <string>

#include "breccia/tables/measured_table_reader.hpp"

#include "input_folder.hpp"
#include "refusal.hpp"
#include "tables/table_description.hpp"
#include "tables/written_archive.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  // NOLINT(*-naming)
  using namespace breccia;
  static const fuzz::InputFolder folder;
  constexpr std::string_view between = "\n=====\n";
  std::map<std::string, std::string> parts = {
      {"xl/workbook.xml", R"(<workbook xmlns:r="r"><sheets><sheet name="A" r:id="a"/></sheets></workbook>)"},
      {"_rels/.rels",
       R"(<Relationships><Relationship Id="b" Type="/officeDocument" Target="/xl/workbook.xml"/></Relationships>)"},
      {"xl/_rels/workbook.xml.rels", R"(<Relationships><Relationship Id="a" Type="/worksheet" Target="sheet.xml"/>)"
                                     R"(<Relationship Id="t" Type="/sharedStrings" Target="sharedStrings.xml"/>)"
                                     R"(<Relationship Id="s" Type="/styles" Target="styles.xml"/></Relationships>)"}};
  auto rest = fuzz::text_of(data, size);
  for (const auto* part : {"xl/sheet.xml", "xl/sharedStrings.xml", "xl/styles.xml"}) {
    const auto end = rest.find(between);
    parts[part] = rest.substr(0, end);
    rest = end == std::string_view::npos ? "" : rest.substr(end + between.size());
  }
  const auto file = folder.path() / "book.xlsx";
  test::write_archive(file, parts, ZIP_CM_STORE);
  fuzz::allow_refusal([&] {
    const auto table = read_measured_table(file);
    static_cast<void>(description_of(table));
  });
  return 0;
}
