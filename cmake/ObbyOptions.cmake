# Build switches. They are few, since each one doubles the configurations to test.
option(OBBY_BUILD_TESTS "Build the tests" ON)
option(OBBY_BASELINES "Build the search methods that learn while they search, for comparison" ON)
option(OBBY_BUILD_BENCH "Build the benches" OFF)
option(OBBY_BUILD_FUZZ "Build the libFuzzer targets (needs clang)" OFF)
option(OBBY_WARNINGS_AS_ERRORS "Treat warnings as errors (CI does)" OFF)
option(OBBY_CHECKS "Keep OBBY_CHECK invariants in every build type" OFF)
option(OBBY_CUDA "Build the CUDA backend with nvcc; fails where no CUDA toolkit is found" OFF)
option(OBBY_PORTABLE "Programs that need no shared libraries but those of glibc" OFF)
option(OBBY_UNITY "Compile sources in groups: a third of the CPU time, but a change recompiles its group" OFF)
option(OBBY_DISPATCH "One x86-64 build for every CPU: hot code for each level, chosen at run time" OFF)
set(OBBY_SANITIZE "" CACHE STRING "Sanitizers, as for -fsanitize=")
set(OBBY_ARCH "" CACHE STRING "Value for -march=; empty: the compiler's baseline. Results are the same for every value.")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_UNITY_BUILD ${OBBY_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 40)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
# CMake's default is -O3. Only the lanes' code gains from it (ObbyLanes.cmake). The rest compiles in
# two thirds of the time.
if(CMAKE_CXX_FLAGS_RELEASE STREQUAL "-O3 -DNDEBUG")
  set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# The compile options of all our targets, linked as obby::build.
add_library(obby_build INTERFACE)
add_library(obby::build ALIAS obby_build)
# GCC 12 reports a false -Wrestrict inside std::string at -O3 (its bug 105651), and at lower levels
# uninitialized variables in its own AVX-512 intrinsics (105593).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(obby_build INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-restrict;-Wno-uninitialized>)
endif()
target_compile_options(obby_build INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wno-sign-conversion>
  # & and | of truth values are intended: they serve both a scalar world and SIMD lanes.
  $<$<COMPILE_LANG_AND_ID:CXX,Clang,AppleClang>:-Wno-bitwise-instead-of-logical>
  # In a unity build a local name may hide one that belongs to another source.
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${OBBY_UNITY}>>:-Wno-shadow>
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${OBBY_WARNINGS_AS_ERRORS}>>:-Werror>
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${OBBY_ARCH}>>:-march=${OBBY_ARCH}>)
target_compile_definitions(obby_build INTERFACE $<$<BOOL:${OBBY_CHECKS}>:OBBY_CHECKS=1>)
if(OBBY_PORTABLE)
  target_link_options(obby_build INTERFACE -static-libstdc++ -static-libgcc -Wl,--as-needed)
endif()
if(OBBY_SANITIZE)
  target_compile_options(obby_build INTERFACE -fsanitize=${OBBY_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(obby_build INTERFACE -fsanitize=${OBBY_SANITIZE})
endif()
