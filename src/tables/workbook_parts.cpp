#include "tables/workbook_parts.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "io/file_mistakes.hpp"
#include "tables/xml_elements.hpp"

namespace breccia::detail {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_archive() {
  throw InputError("expected text or a workbook in the format .xlsx, got another archive; save the table as CSV");
}

pugi::xml_document parsed(const std::string& name, const std::string& bytes) {
  pugi::xml_document document;
  // Blanks between the parts of a text in several fonts count.
  const auto result = document.load_buffer(bytes.data(), bytes.size(), pugi::parse_default | pugi::parse_ws_pcdata);
  if (!result) throw InputError(fmt::format("{} in the workbook is damaged XML: {}", name, result.description()));
  return document;
}

}  // namespace

WorkbookParts::WorkbookParts(std::string_view bytes) : archive_(bytes) {
  for (const auto& [identity, relation] : relations_of("")) {
    if (relation.kind == "officeDocument") workbook_ = relation.part;
  }
  if (workbook_.ends_with(".bin"))
    throw InputError("a binary workbook (.xlsb); save it in the format .xlsx, or its table as CSV");
  if (workbook_.empty() || local_name(workbook().document_element()) != "workbook") refuse_archive();
  relations_ = relations_of(workbook_);
}

pugi::xml_document WorkbookParts::related(const std::string& identity) const {
  const auto found = relations_.find(identity);
  if (found == relations_.end()) throw InputError(fmt::format("the workbook lacks the part {}", shown_value(identity)));
  return part(found->second.part);
}

pugi::xml_document WorkbookParts::related_as(std::string_view kind) const {
  for (const auto& [identity, relation] : relations_) {
    if (relation.kind == kind) return part(relation.part);
  }
  return {};
}

std::map<std::string, WorkbookParts::Relation> WorkbookParts::relations_of(const std::string& path) const {
  const auto folder = fs::path(path).parent_path();
  const auto file = (folder / "_rels" / (fs::path(path).filename().string() + ".rels")).string();
  std::map<std::string, Relation> relations;
  const auto bytes = archive_.entry(file);
  if (!bytes) return relations;
  const auto document = parsed(file, *bytes);
  for (const auto& one : children(document.document_element(), "Relationship")) {
    if (std::string_view(one.attribute("TargetMode").value()) == "External") continue;
    const std::string type = one.attribute("Type").value(), target = one.attribute("Target").value();
    // A target that begins with a slash is a path in the archive, another one is relative to the part.
    const auto place = target.starts_with('/') ? fs::path(target).relative_path() : folder / target;
    relations[one.attribute("Id").value()] = {type.substr(type.rfind('/') + 1), place.lexically_normal().string()};
  }
  return relations;
}

pugi::xml_document WorkbookParts::part(const std::string& path) const {
  const auto bytes = archive_.entry(path);
  if (!bytes) throw InputError(fmt::format("the workbook lacks the part {}", shown_value(path)));
  return parsed(path, *bytes);
}

}  // namespace breccia::detail
