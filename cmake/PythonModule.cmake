# The Python module, where Python, its headers, NumPy and pybind11 are there; BRECCIA_PYTHON=ON requires them.

# Outside of environments that were made for a project the distribution's own Python is meant, whose packages
# scripts/install-dependencies installs. -D Python_EXECUTABLE=... names another one.
if(NOT DEFINED Python_EXECUTABLE AND NOT DEFINED ENV{VIRTUAL_ENV} AND NOT DEFINED ENV{CONDA_PREFIX}
   AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
if(BRECCIA_PYTHON STREQUAL "AUTO")
  find_package(Python 3.9 COMPONENTS Interpreter Development.Module NumPy QUIET)
  find_package(pybind11 2.10 QUIET)
else()
  find_package(Python 3.9 COMPONENTS Interpreter Development.Module NumPy REQUIRED)
  find_package(pybind11 2.10 REQUIRED)
endif()
if(Python_FOUND AND pybind11_FOUND AND BUILD_SHARED_LIBS)
  add_subdirectory(python)
elseif(BRECCIA_PYTHON STREQUAL "ON")
  add_subdirectory(python)
else()
  message(STATUS "The Python module is left out: it takes pybind11, NumPy and a shared libbreccia")
endif()
