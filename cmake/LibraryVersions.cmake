# breccia_library_versions(<variable>): name and version of the libraries that Breccia is compiled with, as text. They
# are as their CMake or pkg-config files say; MUMPS and METIS have none, and say it in their headers.
function(breccia_library_versions variable)
  file(STRINGS ${MUMPS_INCLUDE_DIRECTORY}/dmumps_c.h mumps REGEX "define MUMPS_VERSION ")
  string(REGEX REPLACE ".*\"(.*)\".*" "\\1" mumps "${mumps}")
  file(STRINGS ${METIS_INCLUDE_DIRECTORY}/metis.h metis REGEX "define METIS_VER_[A-Z]+ ")
  string(REGEX REPLACE "[^;]* " "" metis "${metis}")
  string(REPLACE ";" "." metis "${metis}")
  set(versions
    "Eigen ${Eigen3_VERSION}"
    "fmt ${fmt_VERSION}"
    "CLI11 ${CLI11_VERSION}"
    "nlohmann/json ${nlohmann_json_VERSION}"
    "toml++ ${tomlplusplus_VERSION}"
    "UDUNITS ${udunits_VERSION}"
    "HDF5 ${hdf5_VERSION}"
    "libpng ${png_VERSION}"
    "libtiff ${tiff_VERSION}"
    "pugixml ${pugixml_VERSION}"
    "libzip ${libzip_VERSION}"
    "zlib ${zlib_VERSION}"
    "xxHash ${xxhash_VERSION}"
    "PETSc ${petsc_VERSION}"
    "MUMPS ${mumps}"
    "METIS ${metis}"
    "LAPACKE ${lapacke_VERSION}")
  if(BRECCIA_FFTW)
    list(APPEND versions "FFTW ${fftw_VERSION}")
  endif()
  list(JOIN versions ", " versions)
  set(${variable} "${versions}" PARENT_SCOPE)
endfunction()
