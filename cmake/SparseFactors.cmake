# MUMPS::MUMPS and METIS::METIS, the libraries of sparse factors, which have neither pkg-config nor CMake files.
find_path(MUMPS_INCLUDE_DIRECTORY dmumps_c.h REQUIRED)
find_library(MUMPS_LIBRARY dmumps REQUIRED)
find_path(METIS_INCLUDE_DIRECTORY metis.h REQUIRED)
find_library(METIS_LIBRARY metis REQUIRED)
mark_as_advanced(MUMPS_INCLUDE_DIRECTORY MUMPS_LIBRARY METIS_INCLUDE_DIRECTORY METIS_LIBRARY)
foreach(library IN ITEMS MUMPS METIS)
  if(NOT TARGET ${library}::${library})
    add_library(${library}::${library} UNKNOWN IMPORTED)
    set_target_properties(${library}::${library} PROPERTIES
      IMPORTED_LOCATION ${${library}_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${${library}_INCLUDE_DIRECTORY})
  endif()
endforeach()
