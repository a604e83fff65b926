# Writes the commit into a C++ source with a place ${commit}; the file is touched only when the commit has changed:
#
#   cmake -D SOURCE_DIRECTORY=. -D TEMPLATE=build_information.cpp.in -D OUTPUT=build_information.cpp -P BuildInformation.cmake
set(commit "")
find_program(GIT git)
if(GIT)
  # A copy of the sources within another project's repository has no commit of its own.
  execute_process(COMMAND ${GIT} rev-parse --show-prefix
    WORKING_DIRECTORY "${SOURCE_DIRECTORY}" OUTPUT_VARIABLE prefix ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(prefix STREQUAL "")
    execute_process(COMMAND ${GIT} describe --always --dirty --abbrev=8 --exclude=*
      WORKING_DIRECTORY "${SOURCE_DIRECTORY}" OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  endif()
endif()
configure_file("${TEMPLATE}" "${OUTPUT}")
