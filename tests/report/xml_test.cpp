#include "report/xml.hpp"

#include <gtest/gtest.h>

namespace breccia::test {
namespace {

TEST(Xml, PassesWhatIsWellFormed) {
  EXPECT_EQ(xml_mistake(R"(<?xml version="1.0"?><!-- a > b --><a x="1"><b/><c y='2'>&lt; &#181;</c></a>)"), "");
}

TEST(Xml, NamesMistakes) {
  EXPECT_NE(xml_mistake(""), "");
  EXPECT_NE(xml_mistake("<a>"), "");
  EXPECT_NE(xml_mistake("<a></b>"), "");
  EXPECT_NE(xml_mistake("<a/><b/>"), "");
  EXPECT_NE(xml_mistake("<a x=1/>"), "");
  EXPECT_NE(xml_mistake("<a>Q & A</a>"), "");
  EXPECT_NE(xml_mistake(R"(<a x="Q & A"/>)"), "");
  EXPECT_NE(xml_mistake("<a>1 < 2</a>"), "");
}

}  // namespace
}  // namespace breccia::test
