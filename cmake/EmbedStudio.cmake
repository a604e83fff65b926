# Makes a C++ source of the files of the studio's page, with a function that returns each of them:
#
#   cmake -D DOCUMENT=index.html -D STYLE=studio.css -D SCRIPT=main.js -D REFERENCE=decks.md -D ESBUILD=esbuild
#     -D OUTPUT=studio_page.cpp -P EmbedStudio.cmake
#
# SCRIPT is an ES module, with all modules that it imports.
cmake_path(GET SCRIPT PARENT_PATH modules)
cmake_path(GET SCRIPT FILENAME script)
execute_process(
  COMMAND ${ESBUILD} ${script} --bundle --format=esm --target=es2022 --charset=utf8 --log-level=warning
  WORKING_DIRECTORY "${modules}" OUTPUT_VARIABLE scripts RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "esbuild cannot join the modules of ${SCRIPT}")
endif()

file(READ "${DOCUMENT}" document)
file(READ "${STYLE}" style)
file(READ "${REFERENCE}" reference)

# Writes the definition of a function to OUTPUT. As a raw literal the text compiles at once.
function(embed name text)
  file(APPEND "${OUTPUT}.new" "
std::string_view ${name}() {
  using std::literals::operator\"\"sv;
  return R\"breccia(${text})breccia\"sv;
}
")
endfunction()

file(WRITE "${OUTPUT}.new" "#include \"studio/studio_page.hpp\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace breccia::studio {
")
embed(page_document "${document}")
embed(page_style "${style}")
embed(page_script "${scripts}")
embed(key_reference "${reference}")
file(APPEND "${OUTPUT}.new" "
}  // namespace breccia::studio
")
file(RENAME "${OUTPUT}.new" "${OUTPUT}")
