#pragma once

#include <map>
#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "tables/zip_archive.hpp"

namespace breccia::detail {

/// The parts of a workbook, XML documents in an archive that refer to each other by relations (Office Open XML,
/// ECMA-376, Part 2, clause 6.5).
class WorkbookParts {
 public:
  /// The bytes must outlive this object. Throws InputError for archives that are damaged or no workbook.
  explicit WorkbookParts(std::string_view bytes);

  /// The part that lists the sheets.
  [[nodiscard]] pugi::xml_document workbook() const { return part(workbook_); }
  /// A part to which the workbook has the relation of this identity. Throws InputError where it is missing or damaged.
  [[nodiscard]] pugi::xml_document related(const std::string& identity) const;
  /// The part to which the workbook has the one relation of this kind, "styles"; an empty document without one. Throws
  /// as related().
  [[nodiscard]] pugi::xml_document related_as(std::string_view kind) const;

 private:
  /// A relation to another part.
  struct Relation {
    std::string kind;  ///< the last step of its type
    std::string part;  ///< path in the archive
  };
  /// The relations of a part by their identities; of the whole archive for an empty path.
  [[nodiscard]] std::map<std::string, Relation> relations_of(const std::string& path) const;
  [[nodiscard]] pugi::xml_document part(const std::string& path) const;

  ZipArchive archive_;
  std::string workbook_;
  std::map<std::string, Relation> relations_;
};

}  // namespace breccia::detail
