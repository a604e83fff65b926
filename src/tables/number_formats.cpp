#include "tables/number_formats.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "tables/xml_elements.hpp"

namespace breccia::detail {
namespace {

/// A format of numbers that the program which reads a workbook has by itself, by its number.
NumberFormat built_in_format(unsigned number) {
  const auto is_within = [number](unsigned first, unsigned last) { return number >= first && number <= last; };
  if (is_within(9, 10)) return NumberFormat::percentage;
  // 27 to 36 and 50 to 58 are the dates of East Asian locales.
  const bool is_date = is_within(14, 22) || is_within(27, 36) || is_within(45, 47) || is_within(50, 58);
  return is_date ? NumberFormat::date : NumberFormat::number;
}

/// The letters of a format code that stand for parts of a number or a date: without texts in quotes, characters behind
/// a backslash, an underscore or an asterisk, and colours or locales in brackets; elapsed times stay, as in [h]:mm.
std::string letters_of(std::string_view code) {
  std::string letters;
  while (!code.empty()) {
    const char letter = code.front();
    code.remove_prefix(1);
    if (letter == '"' || letter == '[') {
      const auto end = code.find(letter == '"' ? '"' : ']');
      const auto inside = code.substr(0, end);
      const bool is_elapsed = letter == '[' && inside.find_first_not_of("hmsHMS") == std::string_view::npos;
      if (is_elapsed) letters += inside;
      code.remove_prefix(end == std::string_view::npos ? code.size() : end + 1);
    } else if (letter == '\\' || letter == '_' || letter == '*') {
      code.remove_prefix(code.empty() ? 0 : 1);
    } else {
      letters += letter;
    }
  }
  return letters;
}

/// A format by its code, such as "0.00E+00" or "hh:mm:ss".
NumberFormat format_of(std::string_view code) {
  if (code == "General" || code == "Standard") return NumberFormat::number;  // the second one in German
  const auto letters = letters_of(code);
  if (letters.find('%') != std::string::npos) return NumberFormat::percentage;
  // A comma that no digit follows divides by a thousand.
  for (std::size_t at = 0; at < letters.size(); ++at) {
    const bool is_before_digit =
        at + 1 < letters.size() && std::string_view("0#?").find(letters[at + 1]) != std::string_view::npos;
    if (letters[at] == ',' && !is_before_digit) return NumberFormat::scaled;
  }
  return letters.find_first_of("ymdhsYMDHS") == std::string::npos ? NumberFormat::number : NumberFormat::date;
}

}  // namespace

std::vector<NumberFormat> number_formats(const pugi::xml_node& styles) {
  std::map<unsigned, NumberFormat> own;
  for (const auto& one : children(child(styles, "numFmts"), "numFmt")) {
    own[one.attribute("numFmtId").as_uint()] = format_of(one.attribute("formatCode").value());
  }
  std::vector<NumberFormat> formats;
  for (const auto& style : children(child(styles, "cellXfs"), "xf")) {
    const auto number = style.attribute("numFmtId").as_uint();
    const auto found = own.find(number);
    formats.push_back(found == own.end() ? built_in_format(number) : found->second);
  }
  return formats;
}

}  // namespace breccia::detail
