# Debian packages by CPack (scripts/package): the command with its library, the Python module, and what C++ programs are
# compiled with. `cpack` makes one of each component of the installation.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME breccia)
set(CPACK_PACKAGE_VENDOR "The Breccia authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL command development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/CompletePackages.cmake)
set(CPACK_BRECCIA_COPYRIGHT ${CMAKE_CURRENT_LIST_DIR}/copyright)

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "relaxation moduli of highly filled composites") # begins each description
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Breccia authors <breccia@breccia.invalid>") # the project has no address yet
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Where libbreccia is while the programs that are linked with it are examined.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(this_version "(= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME breccia)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMMAND_DESCRIPTION
"Breccia predicts how the stiffness of a highly filled composite falls with
time, from what the composite is made of: the relaxation spectrum of the
binder, the moduli of the filler, the sizes and the fraction of its particles.

This package has the command breccia, its library, example decks, the
documentation, the manual page and the completion for bash and zsh.")
# MUMPS and LAPACK take the time of a calculation with the BLAS, of which OpenBLAS is the fast one.
set(CPACK_DEBIAN_COMMAND_PACKAGE_DEPENDS "libopenblas0-pthread | libopenblas0")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS "python3-breccia, openmpi-bin, paraview")
# Which package has the library, and that the cache of the linker is to be renewed.
configure_file(${CMAKE_CURRENT_LIST_DIR}/command/shlibs.in ${PROJECT_BINARY_DIR}/packaging/shlibs @ONLY)
set(CPACK_DEBIAN_COMMAND_PACKAGE_CONTROL_EXTRA
  ${PROJECT_BINARY_DIR}/packaging/shlibs ${CMAKE_CURRENT_LIST_DIR}/command/triggers)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libbreccia-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"Breccia predicts how the stiffness of a highly filled composite falls with
time, from what the composite is made of.

This package has the headers and the CMake package of its library.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "breccia ${this_version}, libeigen3-dev (>= 3.4), libfmt-dev (>= 9)")

if(TARGET breccia_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  string(CONCAT python_versions
    "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}~), "
    "python3 (<< ${Python_VERSION_MAJOR}.${next_minor})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-breccia)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"Breccia predicts how the stiffness of a highly filled composite falls with
time, from what the composite is made of.

This package has the module breccia for Python 3, for scripts and notebooks,
with its type stubs.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "breccia ${this_version}, ${python_versions}, python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, jupyter-notebook")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_LIST_DIR}/python/postinst ${CMAKE_CURRENT_LIST_DIR}/python/prerm)
endif()

include(CPack)
