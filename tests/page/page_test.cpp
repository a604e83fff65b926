#include "page/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace breccia {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(ReportPage, NeedsNoOtherFile) {
  const auto page = study_page("T", "{}");
  EXPECT_THAT(page, AllOf(HasSubstr("Plotly"), HasSubstr("--paper"), HasSubstr("default-src 'none'")));
  EXPECT_THAT(page, AllOf(Not(HasSubstr("<script src")), Not(HasSubstr("<link"))));
  for (const auto* part : {"<!--TITLE-->", "<!--STYLE-->", "<!--DATA-->", "<!--LIBRARY-->", "<!--SCRIPTS-->"}) {
    EXPECT_THAT(page, Not(HasSubstr(part)));
  }
}

TEST(ReportPage, OfASweepIsAnother) {
  const auto page = sweep_page("T", "{}");
  EXPECT_THAT(page, AllOf(HasSubstr("Plotly"), HasSubstr("default-src 'none'"), HasSubstr("sweepFigure")));
  EXPECT_THAT(page, Not(HasSubstr("<!--SCRIPTS-->")));
  EXPECT_THAT(study_page("T", "{}"), Not(HasSubstr("sweepFigure")));
}

TEST(ReportPage, OfAFitIsAnother) {
  const auto page = fit_page("T", "{}");
  EXPECT_THAT(page, AllOf(HasSubstr("Plotly"), HasSubstr("default-src 'none'"), HasSubstr("blackFigure")));
  EXPECT_THAT(page, AllOf(Not(HasSubstr("<!--SCRIPTS-->")), Not(HasSubstr("sweepFigure"))));
}

TEST(ReportPage, TextCannotLeaveItsPlace) {
  const auto page = study_page("a </title><script>b & c", R"({"deck_text":"</script><script>d"})");
  EXPECT_THAT(page, HasSubstr("<title>a &lt;/title>&lt;script>b &amp; c</title>"));
  EXPECT_THAT(page, HasSubstr(R"({"deck_text":"\u003c/script>\u003cscript>d"}</script>)"));
}

TEST(ReportPage, HasViewsOfThreeDimensionsOnlyWhereTheyAreAskedFor) {
  const auto page = study_page("T", "{}"), with_views = study_page_with_views("T", R"({"views":{}})");
  constexpr auto licence = "Three.js Authors";
  for (const auto& one : {page, sweep_page("T", "{}")}) {
    EXPECT_THAT(one, AllOf(Not(HasSubstr(licence)), Not(HasSubstr("rotatableView")), Not(HasSubstr("<!--VIEWS-->"))));
  }
  EXPECT_THAT(with_views, AllOf(HasSubstr(licence), HasSubstr("rotatableView"), HasSubstr(R"({"views":{}})")));
  EXPECT_THAT(with_views, testing::EndsWith("</html>\n"));
}

}  // namespace
}  // namespace breccia
