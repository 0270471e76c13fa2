# All external libraries, with the modules that use them. scripts/setup installs the Debian
# packages.
find_package(Threads REQUIRED)
find_package(CapnProto REQUIRED)       # schema, io
find_package(nlohmann_json REQUIRED)   # io
find_package(fmt REQUIRED)             # io and above
find_package(CLI11 REQUIRED)           # cli
find_package(Eigen3 REQUIRED)          # import, nn, calibrate
find_package(pugixml REQUIRED)         # io, import
set(ZLIB_USE_STATIC_LIBS ${OBBY_PORTABLE})
find_package(ZLIB REQUIRED)            # bridge: for Cap'n Proto's gzip streams
find_package(PNG REQUIRED)             # view: pictures
find_package(PkgConfig REQUIRED)
pkg_check_modules(lz4 REQUIRED IMPORTED_TARGET liblz4)     # import
pkg_check_modules(zstd REQUIRED IMPORTED_TARGET libzstd)   # import
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)  # base: digests
pkg_check_modules(lua REQUIRED lua5.1-c++)                 # engine: runs a place's scripts
find_library(OBBY_LUA NAMES liblua5.1-c++.a lua5.1-c++ REQUIRED)
pkg_check_modules(seccomp REQUIRED libseccomp)             # engine: the sandbox of these scripts
find_library(OBBY_SECCOMP NAMES libseccomp.a seccomp REQUIRED)
find_path(RANDOM123_INCLUDE Random123/philox.h REQUIRED)   # base: counter-based random numbers
if(NOT OBBY_PORTABLE)
  find_package(MPI QUIET COMPONENTS C)  # lib/train/run/ranks: optional
endif()
if(OBBY_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif()
if(OBBY_BUILD_TESTS OR OBBY_BUILD_BENCH)
  include(ObbyReferences)
endif()
if(OBBY_CUDA)
  find_package(CUDAToolkit REQUIRED)
  if(NOT OBBY_PORTABLE)
    # lib/train/run/ranks: optional
    find_path(OBBY_NCCL_INCLUDE nccl.h HINTS ${CUDAToolkit_INCLUDE_DIRS})
    find_library(OBBY_NCCL_LIBRARY nccl HINTS ${CUDAToolkit_LIBRARY_DIR})
  endif()
endif()
if(OBBY_PORTABLE)
  include(ObbyPortable)
endif()
