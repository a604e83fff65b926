# MUMPS::MUMPS and METIS::METIS, the libraries of sparse factors, which have neither pkg-config nor CMake files.
# MUMPS_FOUND and METIS_FOUND tell which of them are there.
find_path(MUMPS_INCLUDE_DIRECTORY dmumps_c.h)
find_library(MUMPS_LIBRARY dmumps)
find_path(METIS_INCLUDE_DIRECTORY metis.h)
find_library(METIS_LIBRARY metis)
mark_as_advanced(MUMPS_INCLUDE_DIRECTORY MUMPS_LIBRARY METIS_INCLUDE_DIRECTORY METIS_LIBRARY)
foreach(library IN ITEMS MUMPS METIS)
  set(${library}_FOUND FALSE)
  if(${library}_INCLUDE_DIRECTORY AND ${library}_LIBRARY)
    set(${library}_FOUND TRUE)
  endif()
  if(${library}_FOUND AND NOT TARGET ${library}::${library})
    add_library(${library}::${library} UNKNOWN IMPORTED)
    set_target_properties(${library}::${library} PROPERTIES
      IMPORTED_LOCATION ${${library}_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${${library}_INCLUDE_DIRECTORY})
  endif()
endforeach()
