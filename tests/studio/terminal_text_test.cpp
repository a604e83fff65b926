#include "studio/terminal_text.hpp"

#include <string_view>

#include <gtest/gtest.h>

namespace breccia::studio {
namespace {

TEST(TerminalText, KeepsLinesAndTheLiveLineApart) {
  TerminalText text;
  text.add("packed\r\n\r\x1b[Ka: 10 %, 1 s left\r\x1b[Ka: 55 %, 1 s left");
  EXPECT_EQ(text.lines(), "packed\n");
  EXPECT_EQ(text.live_line(), "a: 55 %, 1 s left");
  text.add("\r\x1b[Ka: done\r\n");
  EXPECT_EQ(text.lines(), "packed\na: done\n");
  EXPECT_EQ(text.live_line(), "");
}

TEST(TerminalText, TakesBytesOneByOne) {
  constexpr std::string_view bytes = "one\r\n\r\x1b[Klive\r\x1b[K\x1b[1mtwo\x1b[0m\r\nthree";
  TerminalText text;
  for (std::size_t i = 0; i < bytes.size(); ++i) text.add(bytes.substr(i, 1));
  EXPECT_EQ(text.lines(), "one\ntwo\n");
  EXPECT_EQ(text.live_line(), "three");
  text.finish();
  EXPECT_EQ(text.lines(), "one\ntwo\nthree\n");
}

TEST(TerminalText, KeepsEmptyLines) {
  TerminalText text;
  text.add("one\n\ntwo\n");
  EXPECT_EQ(text.lines(), "one\n\ntwo\n");
}

TEST(TerminalText, AReturnWithoutAnEraseReplacesTheLine) {
  TerminalText text;
  text.add("10 %\r20 %");
  EXPECT_EQ(text.live_line(), "20 %");
}

TEST(ShareIn, ReadsLinesOfProgressAlone) {
  EXPECT_EQ(share_in("composite, 64 cells, quasi-static: 45 %, snapshot 4, 1.2 s left"), 0.45);
  EXPECT_EQ(share_in("a: 0 %, begun"), 0.0);
  EXPECT_EQ(share_in("a: 100 %, done, 5 s so far"), 1.0);
  EXPECT_EQ(share_in("particles fill 50.27 % of the box"), std::nullopt);
  EXPECT_EQ(share_in(" %, nothing"), std::nullopt);
  EXPECT_EQ(share_in("a: 999999999999 %, much"), std::nullopt);
  EXPECT_EQ(share_in(""), std::nullopt);
}

}  // namespace
}  // namespace breccia::studio
