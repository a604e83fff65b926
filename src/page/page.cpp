#include "page/page.hpp"

#include <utility>

#include <fmt/format.h>

#include "breccia/error.hpp"

#include "page/page_templates.hpp"
#include "report/markup.hpp"

namespace breccia {
namespace {

std::string replaced(std::string_view text, char sign, std::string_view with) {
  std::string result;
  for (const char c : text) {
    if (c == sign) {
      result += with;
    } else {
      result += c;
    }
  }
  return result;
}

/// Escapes the sign < of a JSON text, where it occurs within strings only, so that nothing ends the element of the
/// data.
std::string as_script(std::string_view json) {
  return replaced(json, '<', "\\u003c");
}

/// The parts of a text before and after a marker.
std::pair<std::string_view, std::string_view> split_at(std::string_view text, std::string_view marker) {
  const auto at = text.find(marker);
  if (at == std::string_view::npos) throw FileError(fmt::format("page of the report: no {} in it", marker));
  return {text.substr(0, at), text.substr(at + marker.size())};
}

std::string filled(std::string_view page, std::string_view title, std::string_view data, std::string_view views) {
  const auto [before_title, after_title] = split_at(page, "<!--TITLE-->");
  const auto [before_data, after_data] = split_at(after_title, "<!--DATA-->");
  const auto [before_views, after_views] = split_at(after_data, "<!--VIEWS-->\n");
  return fmt::format("{}{}{}{}{}{}{}", before_title, as_markup(title), before_data, as_script(data), before_views,
                     views, after_views);
}

}  // namespace

std::string study_page(std::string_view title, std::string_view data) {
  return filled(study_page_template(), title, data, {});
}

std::string study_page_with_views(std::string_view title, std::string_view data) {
  return filled(study_page_template(), title, data, views_scripts());
}

std::string sweep_page(std::string_view title, std::string_view data) {
  return filled(sweep_page_template(), title, data, {});
}

std::string assess_page(std::string_view title, std::string_view data) {
  return filled(assess_page_template(), title, data, {});
}

std::string fit_page(std::string_view title, std::string_view data) {
  return filled(fit_page_template(), title, data, {});
}

}  // namespace breccia
