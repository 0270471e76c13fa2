# One function each for adding a library module, a tool and a test.

# obby_module(name SOURCES ... USES modules... LIBS imported targets...)
# A folder of lib/. `USES` may only name modules before it in the order of lib/CMakeLists.txt. A
# module without sources has only headers.
function(obby_module name)
  cmake_parse_arguments(M "" "" "SOURCES;USES;LIBS" ${ARGN})
  list(TRANSFORM M_USES PREPEND obby::)
  if(M_SOURCES)
    add_library(obby_${name} STATIC ${M_SOURCES})
    target_include_directories(obby_${name} PUBLIC ${PROJECT_SOURCE_DIR}/lib)
    target_link_libraries(obby_${name} PUBLIC ${M_USES} ${M_LIBS} obby::build)
  else()
    add_library(obby_${name} INTERFACE)
    target_include_directories(obby_${name} INTERFACE ${PROJECT_SOURCE_DIR}/lib)
    target_link_libraries(obby_${name} INTERFACE ${M_USES} ${M_LIBS} obby::build)
  endif()
  add_library(obby::${name} ALIAS obby_${name})
endfunction()

# obby_cold(target): compiles code that is not performance-critical, such as options, tables and
# tests, at -O1 in half the time.
function(obby_cold target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# obby_tool(name USES modules...): builds the program <name> from tools/<name>/main.cpp and
# options.cpp.
function(obby_tool name)
  cmake_parse_arguments(T "" "" "USES;LIBS" ${ARGN})
  list(TRANSFORM T_USES PREPEND obby::)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${name} ${sources})
  obby_cold(${name})
  target_link_libraries(${name} PRIVATE ${T_USES} ${T_LIBS} obby::build)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  obby_manual(${name})
endfunction()

# obby_test(module USES modules...): builds one program from tests/<module>/*_test.cpp. Each test is
# a ctest entry.
function(obby_test module)
  cmake_parse_arguments(T "" "" "USES;LIBS" ${ARGN})
  list(TRANSFORM T_USES PREPEND obby::)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${module}/*_test.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${module} ${sources})
  target_include_directories(test_${module} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(test_${module} PRIVATE ${T_USES} ${T_LIBS} GTest::gtest_main GTest::gmock obby::build)
  obby_cold(test_${module})
  target_compile_definitions(test_${module} PRIVATE
    OBBY_SOURCE_DIR="${PROJECT_SOURCE_DIR}" OBBY_BIN_DIR="${PROJECT_BINARY_DIR}/bin")
  include(GoogleTest)
  # Some take 40 s on a fast machine next to another test. The limits are for tests that hang.
  gtest_discover_tests(test_${module} TEST_PREFIX ${module}/ DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 600)
endfunction()
