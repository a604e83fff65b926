# Puts a page of the report together, and makes a C++ source of it with a function that returns it:
#
#   cmake -D PAGE=page.html -D STYLE=style.css -D LIBRARY=plot.js -D "SCRIPTS=a.js;b.js" -D FUNCTION=page_template
#     -D OUTPUT=page_template.cpp -P EmbedPage.cmake
file(READ "${PAGE}" page)
file(READ "${STYLE}" style)
file(READ "${LIBRARY}" library)
set(scripts "")
foreach(script IN LISTS SCRIPTS)
  file(READ "${script}" text)
  string(APPEND scripts "${text}\n")
endforeach()
string(REPLACE "<!--STYLE-->" "${style}" page "${page}")
string(REPLACE "<!--SCRIPTS-->" "${scripts}" page "${page}")
string(REPLACE "<!--LIBRARY-->" "${library}" page "${page}")

# As numbers, because compilers limit the length of a literal and what may stand in it.
file(WRITE "${OUTPUT}.html" "${page}")
file(READ "${OUTPUT}.html" bytes HEX)
string(REPEAT "." 40 line)
string(REGEX REPLACE "(${line})" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${OUTPUT}" "#include \"page_templates.hpp\"

namespace breccia {
namespace {

constexpr unsigned char bytes[] = {
${bytes}
};

}  // namespace

std::string_view ${FUNCTION}() {
  return {reinterpret_cast<const char*>(bytes), sizeof bytes};
}

}  // namespace breccia
")
