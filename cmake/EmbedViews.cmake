# Makes the scripts of the rotatable views, and a C++ source of them with a function that returns them as two elements
# of a page:
#
#   cmake -D LIBRARY=three.js -D LIBRARY_DIRECTORY=node_modules/three -D SCRIPT=views_main.js -D ESBUILD=esbuild
#     -D FUNCTION=views_scripts -D OUTPUT=views_scripts.cpp -P EmbedViews.cmake
#
# LIBRARY is an ES module that exports what the views take of three.js; it becomes the global THREE, minified. SCRIPT is
# joined with all modules that it imports, and can be read in the page.
cmake_path(GET SCRIPT PARENT_PATH modules)
cmake_path(GET SCRIPT FILENAME script)
cmake_path(GET LIBRARY FILENAME library)
execute_process(
  COMMAND ${ESBUILD} ${library} --bundle --minify --format=iife --global-name=THREE --target=es2022 --charset=utf8
    --alias:three=${LIBRARY_DIRECTORY} --legal-comments=eof --log-level=warning
  WORKING_DIRECTORY "${modules}" OUTPUT_VARIABLE library_text RESULT_VARIABLE library_result)
execute_process(
  COMMAND ${ESBUILD} ${script} --bundle --format=iife --banner:js=\"use\ strict\"\; --target=es2022 --charset=utf8
    --log-level=warning
  WORKING_DIRECTORY "${modules}" OUTPUT_VARIABLE script_text RESULT_VARIABLE script_result)
if(NOT library_result EQUAL 0 OR NOT script_result EQUAL 0)
  message(FATAL_ERROR "esbuild cannot join the modules of ${SCRIPT} and ${LIBRARY}")
endif()

file(WRITE "${OUTPUT}" "#include \"page/page_templates.hpp\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace breccia {

std::string_view ${FUNCTION}() {
  using std::literals::operator\"\"sv;
  return R\"breccia(<script>
${library_text}</script>
<script>
${script_text}</script>
)breccia\"sv;
}

}  // namespace breccia
")
