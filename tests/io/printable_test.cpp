#include "io/printable.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace breccia {
namespace {

TEST(Printable, TextOfAnyLanguageStaysAsItIs) {
  for (const auto* text : {"", "a b", "Übung µm °C", "試料", "🙂"}) {
    EXPECT_TRUE(is_printable(text)) << text;
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, ControlCharactersAndBrokenBytesAreEscaped) {
  const std::vector<std::pair<std::string, const char*>> cases = {
      {"a\nb", "a\\u000ab"},
      {"\x1b[2J", "\\u001b[2J"},
      {"\x7f", "\\u007f"},
      {"\xc2\x85", "\\u0085"},  // next line
      {"\xb0"
       "C",
       "\\xb0C"},                           // Latin-1
      {"\xc3", "\\xc3"},                    // a cut character
      {"\xc0\xaf", R"(\xc0\xaf)"},          // an encoding that is longer than needed
      {"\xed\xa0\x80", R"(\xed\xa0\x80)"},  // half of a surrogate pair
  };
  for (const auto& [text, escaped] : cases) {
    EXPECT_FALSE(is_printable(text)) << escaped;
    EXPECT_EQ(printable(text), escaped);
  }
}

}  // namespace
}  // namespace breccia
