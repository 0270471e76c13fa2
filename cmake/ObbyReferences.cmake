# Optional libraries for tests, as references or as sources of random input. Without them ctest
# shows the tests as skipped.
find_package(rapidcheck QUIET)  # tests/sim: property tests
find_package(fcl QUIET)         # tests/parity
find_path(BULLET_INCLUDE btBulletCollisionCommon.h PATH_SUFFIXES bullet)  # tests/parity, in double precision
find_library(BULLET_COLLISION BulletCollision-float64)
find_library(BULLET_DYNAMICS BulletDynamics-float64)
find_library(BULLET_MATH LinearMath-float64)
if(BULLET_INCLUDE AND BULLET_COLLISION AND BULLET_DYNAMICS AND BULLET_MATH)
  add_library(bullet INTERFACE IMPORTED)
  target_include_directories(bullet SYSTEM INTERFACE ${BULLET_INCLUDE})
  target_compile_definitions(bullet INTERFACE BT_USE_DOUBLE_PRECISION)
  target_link_libraries(bullet INTERFACE ${BULLET_DYNAMICS} ${BULLET_COLLISION} ${BULLET_MATH})
endif()
# The single-precision build, as in games: the other engine in tests/calibrate and in benches. It
# must not be linked together with the target above.
if(NOT OBBY_PORTABLE)
  pkg_check_modules(bullet IMPORTED_TARGET bullet)
endif()
# bench_quality: the planner SST. Not by find_package, since Debian's configuration file names Boost
# libraries that the package does not depend on.
find_path(OMPL_INCLUDE ompl/control/planners/sst/SST.h PATH_SUFFIXES ompl-1.5 ompl)
find_library(OMPL_LIBRARY ompl)
if(OMPL_INCLUDE AND OMPL_LIBRARY AND NOT OBBY_PORTABLE)
  add_library(ompl INTERFACE IMPORTED)
  target_include_directories(ompl SYSTEM INTERFACE ${OMPL_INCLUDE})
  target_link_libraries(ompl INTERFACE ${OMPL_LIBRARY} Eigen3::Eigen)
endif()

# obby_absent_test(name packages...): adds a ctest entry that is skipped, with the missing packages.
function(obby_absent_test name)
  list(JOIN ARGN ", " packages)
  message(STATUS "Left out: tests of ${name}, which want ${packages} (scripts/setup test reference)")
  add_test(NAME ${name}/left-out COMMAND ${CMAKE_COMMAND} -E echo "left out without ${packages}")
  set_tests_properties(${name}/left-out PROPERTIES SKIP_REGULAR_EXPRESSION "left out without")
endfunction()
