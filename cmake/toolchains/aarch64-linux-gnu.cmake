# Compiles for 64-bit ARM with Debian's cross compiler against the libraries in BRECCIA_SYSROOT, and runs what was
# compiled, such as tests, in QEMU. scripts/cross-test makes such a directory.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(BRECCIA_SYSROOT "" CACHE PATH "Root of a Debian system for 64-bit ARM")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES BRECCIA_SYSROOT)

set(CMAKE_SYSROOT ${BRECCIA_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(libraries ${BRECCIA_SYSROOT}/usr/lib/aarch64-linux-gnu)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${BRECCIA_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR} ${libraries}/pkgconfig:${BRECCIA_SYSROOT}/usr/share/pkgconfig)

# The wrapper compiler of Open MPI would have to run on ARM; what it would say stands here.
set(MPI_SKIP_COMPILER_WRAPPER ON)
set(MPI_CXX_HEADER_DIR ${libraries}/openmpi/include CACHE PATH "")
set(MPI_CXX_LIB_NAMES mpi_cxx mpi CACHE STRING "")
set(MPI_mpi_cxx_LIBRARY ${libraries}/libmpi_cxx.so.40 CACHE FILEPATH "")
set(MPI_mpi_LIBRARY ${libraries}/libmpi.so.40 CACHE FILEPATH "")

set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L ${BRECCIA_SYSROOT})
