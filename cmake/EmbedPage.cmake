# Puts a page of the report together, and makes a C++ source of it with a function that returns it:
#
#   cmake -D FRAME=frame.html -D SECTIONS=page.html -D STYLE=style.css -D LIBRARY=plot.js -D "SCRIPTS=a.js;b.js"
#     -D FUNCTION=page_template -D OUTPUT=page_template.cpp -P EmbedPage.cmake
file(READ "${FRAME}" page)
file(READ "${SECTIONS}" sections)
file(READ "${STYLE}" style)
file(READ "${LIBRARY}" library)
set(scripts "")
foreach(script IN LISTS SCRIPTS)
  file(READ "${script}" text)
  string(APPEND scripts "${text}\n")
endforeach()
string(REPLACE "<!--SECTIONS-->\n" "${sections}" page "${page}")
string(REPLACE "<!--STYLE-->" "${style}" page "${page}")
string(REPLACE "<!--SCRIPTS-->" "${scripts}" page "${page}")
string(REPLACE "<!--LIBRARY-->" "${library}" page "${page}")

# As a raw literal, which compiles in no time where the same bytes as numbers take a minute and gigabytes.
file(WRITE "${OUTPUT}" "#include \"page_templates.hpp\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace breccia {
namespace {

constexpr char page[] = R\"breccia(${page})breccia\";

}  // namespace

std::string_view ${FUNCTION}() {
  return {page, sizeof page - 1};
}

}  // namespace breccia
")
