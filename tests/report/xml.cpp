#include "report/xml.hpp"

#include <regex>
#include <vector>

namespace breccia::test {

namespace {

/// Text between tags, or the value of an attribute, may hold '&' only as the start of an entity.
bool is_clean(const std::string& text) {
  static const std::regex bare_ampersand("&(?!(amp|lt|gt|quot|apos|#[0-9]+|#x[0-9a-fA-F]+);)");
  return text.find('<') == std::string::npos && !std::regex_search(text, bare_ampersand);
}

}  // namespace

std::string xml_mistake(std::string_view text) {
  static const std::regex element(
      R"re((/?)([A-Za-z_:][\w:.-]*)((?:\s+[\w:.-]+\s*=\s*(?:"[^"<]*"|'[^'<]*'))*)\s*(/?))re");
  std::vector<std::string> open;
  bool has_root = false;
  while (!text.empty()) {
    const auto begin = text.find('<');
    if (!is_clean(std::string(text.substr(0, begin)))) return "stray & in " + std::string(text.substr(0, begin));
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin);

    const bool is_comment = text.starts_with("<!--");
    const bool is_declaration = text.starts_with("<?") || text.starts_with("<!");
    const std::string_view closing = is_comment ? "-->" : ">";
    const auto end = text.find(closing);
    if (end == std::string_view::npos) return "no end of " + std::string(text.substr(0, 40));
    const std::string tag(text.substr(1, end - 1));
    text.remove_prefix(end + closing.size());
    if (is_declaration) continue;

    std::smatch part;
    if (!std::regex_match(tag, part, element)) return "bad tag <" + tag + ">";
    if (!is_clean(part[3])) return "stray & in <" + tag + ">";
    if (part[1].length() == 0) {
      if (open.empty() && has_root) return "a second root <" + tag + ">";
      has_root = true;
      if (part[4].length() == 0) open.push_back(part[2]);
    } else {
      if (open.empty() || open.back() != part[2]) return "unexpected <" + tag + ">";
      open.pop_back();
    }
  }
  if (!has_root) return "no element";
  return open.empty() ? "" : "no end of <" + open.back() + ">";
}

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

}  // namespace breccia::test
