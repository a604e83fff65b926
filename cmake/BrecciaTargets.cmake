# Targets of the project: the options every target is compiled with, the modules, the library that joins them.

include(CMakePackageConfigHelpers)

# What every target of the project is compiled with.
add_library(breccia_options INTERFACE)
target_compile_features(breccia_options INTERFACE cxx_std_20)
# The headers that are promised to users are in include/, those of the modules for one another in src/.
target_include_directories(breccia_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
# Products of small matrices gain nothing from threads of their own, which spin while ours work.
target_compile_definitions(breccia_options INTERFACE BRECCIA_VERSION="${PROJECT_VERSION}" EIGEN_DONT_PARALLELIZE)
# No contraction of a*b+c: the same bits from every instruction set and compiler.
target_compile_options(breccia_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -ffp-contract=off
  $<$<BOOL:${BRECCIA_WARNINGS_AS_ERRORS}>:-Werror>)
if(CMAKE_UNITY_BUILD)
  # To g++ the sources that it compiles as one are headers, whose unnamed namespaces others could see.
  target_compile_options(breccia_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
if(BRECCIA_SANITIZE)
  # Instrumented code looks uninitialised, and copies of texts look as if they overlap, to g++ where they do not.
  target_compile_options(breccia_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-restrict>")
  target_link_options(breccia_options INTERFACE -fsanitize=address,undefined)
endif()
if(BRECCIA_BUILD_FUZZ)
  target_compile_options(breccia_options INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(breccia_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Headers of libraries that most sources include.
set(breccia_common_headers
  <algorithm> <array> <chrono> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers>
  <numeric> <optional> <set> <span> <sstream> <string> <string_view> <utility> <variant> <vector> <fmt/format.h>
  <fmt/ranges.h>)

# breccia_precompiled(<name> HEADERS <header>... LIBRARIES <target>...)
# Headers that are parsed once for all targets with these libraries' options instead of once in each source. Headers of
# Breccia are not among them: a change of one would compile everything anew. The preset `clang` does without, so that
# each source is seen to include what it needs.
function(breccia_precompiled name)
  cmake_parse_arguments(arg "" "" "HEADERS;LIBRARIES" ${ARGN})
  set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE breccia_options ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

# breccia_module(<name> SOURCES <file>... [LIBRARIES <target>...])
# One module of src/: an object library, with the libraries it needs beyond Eigen, fmt and OpenMP.
function(breccia_module name)
  cmake_parse_arguments(module "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_library(breccia_${name} OBJECT ${module_SOURCES})
  set_target_properties(breccia_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(breccia_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(breccia_${name} PRIVATE
    breccia_options Eigen3::Eigen fmt::fmt OpenMP::OpenMP_CXX ${module_LIBRARIES})
  target_precompile_headers(breccia_${name} REUSE_FROM breccia_headers)
  set_property(GLOBAL APPEND PROPERTY breccia_libraries ${module_LIBRARIES})
endfunction()

# breccia_library(<module>...): libbreccia, made of all modules, and its CMake package.
function(breccia_library)
  add_library(breccia)
  add_library(breccia::breccia ALIAS breccia)
  foreach(module IN LISTS ARGN)
    target_sources(breccia PRIVATE $<TARGET_OBJECTS:breccia_${module}>)
  endforeach()
  get_property(libraries GLOBAL PROPERTY breccia_libraries)
  get_property(objects GLOBAL PROPERTY breccia_objects)
  target_sources(breccia PRIVATE ${objects})
  set_target_properties(breccia PROPERTIES
    LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  target_compile_features(breccia PUBLIC cxx_std_20)
  target_include_directories(breccia PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(breccia PUBLIC Eigen3::Eigen fmt::fmt)
  target_link_libraries(breccia PRIVATE $<BUILD_INTERFACE:breccia_options> OpenMP::OpenMP_CXX ${libraries})

  # The components of the installation are the packages of packaging/DebianPackages.cmake.
  install(TARGETS breccia EXPORT brecciaTargets
    LIBRARY COMPONENT command NAMELINK_COMPONENT development
    ARCHIVE COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/breccia
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
  install(EXPORT brecciaTargets
    NAMESPACE breccia:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/breccia COMPONENT development)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/brecciaConfig.cmake.in
    ${PROJECT_BINARY_DIR}/brecciaConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/breccia)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/brecciaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/brecciaConfig.cmake ${PROJECT_BINARY_DIR}/brecciaConfigVersion.cmake ${PROJECT_SOURCE_DIR}/cmake/SparseFactors.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/breccia COMPONENT development)
endfunction()

# Tests spend their time in the library. Where several are compiled as one, names of one are no matter of another.
add_library(breccia_test_options INTERFACE)
target_compile_options(breccia_test_options INTERFACE
  $<$<CONFIG:Release,RelWithDebInfo>:-O0> $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-shadow>)

# The time that a test may take [s]. Sanitizers make a program up to ten times slower.
set(breccia_test_limit 600)
if(BRECCIA_SANITIZE)
  set(breccia_test_limit 3600)
endif()

# breccia_test(<module> SOURCES <file>...): the unit tests of one module.
function(breccia_test module)
  cmake_parse_arguments(test "" "" "SOURCES;LIBRARIES" ${ARGN})
  file(GLOB beside RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS *_test.cpp)
  list(REMOVE_ITEM beside ${test_SOURCES})
  if(beside)
    message(FATAL_ERROR "tests that nothing would compile, in ${CMAKE_CURRENT_SOURCE_DIR}: ${beside}")
  endif()
  add_executable(${module}_test ${test_SOURCES})
  target_include_directories(${module}_test PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${module}_test PRIVATE
    breccia_options breccia_test_options breccia::breccia GTest::gtest_main GTest::gmock ${test_LIBRARIES})
  target_precompile_headers(${module}_test REUSE_FROM breccia_test_headers)
  gtest_discover_tests(${module}_test TEST_PREFIX ${module}. NO_PRETTY_TYPES NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT ${breccia_test_limit} ENVIRONMENT GOMP_SPINCOUNT=1000) # as src/cli/thread_waiting.hpp, beside tests
endfunction()

# breccia_mpirun_test(<name> <processes> <target> [<argument>...]): a program that several processes run together. Root in
# a container, more processes than cores, and cores that are busy with other work are all fine for a test.
function(breccia_mpirun_test name processes target)
  add_test(NAME ${name} COMMAND ${MPIEXEC_EXECUTABLE} -n ${processes} $<TARGET_FILE:${target}> ${ARGN})
  set(environment OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
    OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_mpi_yield_when_idle=1)
  set_tests_properties(${name} PROPERTIES TIMEOUT 120 ENVIRONMENT "${environment}")
endfunction()
