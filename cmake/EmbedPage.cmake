# Puts a page of the report together, and makes a C++ source of it with a function that returns it:
#
#   cmake -D FRAME=frame.html -D SECTIONS=page.html -D STYLE=style.css -D LIBRARY=plot.js -D SCRIPT=page_main.js
#     -D ESBUILD=esbuild -D FUNCTION=page_template -D OUTPUT=page_template.cpp -P EmbedPage.cmake
#
# SCRIPT is an ES module; esbuild joins it with all modules that it imports into one script. It is run in the folder of
# the modules, so that the script does not depend on where the sources are.
cmake_path(GET SCRIPT PARENT_PATH modules)
cmake_path(GET SCRIPT FILENAME script)
execute_process(
  COMMAND ${ESBUILD} ${script} --bundle --format=iife --banner:js=\"use\ strict\"\; --target=es2022 --charset=utf8
    --log-level=warning
  WORKING_DIRECTORY "${modules}" OUTPUT_VARIABLE scripts RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "esbuild cannot join the modules of ${SCRIPT}")
endif()

file(READ "${FRAME}" page)
file(READ "${SECTIONS}" sections)
file(READ "${STYLE}" style)
file(READ "${LIBRARY}" library)
string(REPLACE "<!--SECTIONS-->\n" "${sections}" page "${page}")
string(REPLACE "<!--STYLE-->" "${style}" page "${page}")
string(REPLACE "<!--SCRIPTS-->" "${scripts}" page "${page}")
string(REPLACE "<!--LIBRARY-->" "${library}" page "${page}")

# As a raw literal, which compiles in no time where the same bytes as numbers take a minute and gigabytes.
file(WRITE "${OUTPUT}" "#include \"page/page_templates.hpp\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace breccia {

std::string_view ${FUNCTION}() {
  using std::literals::operator\"\"sv;
  return R\"breccia(${page})breccia\"sv;
}

}  // namespace breccia
")
