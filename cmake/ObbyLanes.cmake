# Compiles code for several x86-64 levels (OBBY_DISPATCH), so that one package serves every CPU.
#
# The danger is the one-definition rule: an inline function or template that one file compiles for
# AVX-512 must not serve baseline code of another. So the objects of one level are linked into one
# object, whose symbols are made local except for a table of functions. The build checks that
# nothing else can be linked to. Inline functions come in section groups that the linker merges by
# name; the first step dissolves them.
set(OBBY_LEVELS v1 v2 v3 v4)  # as in lib/base/cpu_level.h

if(OBBY_DISPATCH)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    message(FATAL_ERROR "OBBY_DISPATCH needs GCC on x86-64")
  endif()
  if(OBBY_ARCH)
    message(FATAL_ERROR "OBBY_DISPATCH chooses at run time; leave OBBY_ARCH empty")
  endif()
endif()

# obby_lane_code(module SOURCES sources...): adds them to the module at -O3, compiled once, or with
# OBBY_DISPATCH for each level. lib/<module>/lane_table.cpp then lists their functions, and
# lane_dispatch.cpp calls those of the CPU's level.
function(obby_lane_code module)
  cmake_parse_arguments(L "" "" "SOURCES" ${ARGN})
  # At -O2 the batch simulator is a fifth slower. In a unity build, tick.cpp takes GCC 12 twice as
  # long.
  set_source_files_properties(${L_SOURCES} PROPERTIES
    COMPILE_OPTIONS $<$<CONFIG:Release>:-O3> SKIP_UNITY_BUILD_INCLUSION ON)
  if(NOT OBBY_DISPATCH)
    target_sources(obby_${module} PRIVATE ${L_SOURCES})
    return()
  endif()
  target_sources(obby_${module} PRIVATE lane_dispatch.cpp)
  foreach(level ${OBBY_LEVELS})
    set(code obby_${module}_${level})
    add_library(${code} OBJECT ${L_SOURCES} lane_table.cpp)
    target_include_directories(${code} PRIVATE ${PROJECT_SOURCE_DIR}/lib)
    target_link_libraries(${code} PRIVATE $<TARGET_PROPERTY:obby_${module},LINK_LIBRARIES>)
    set_target_properties(${code} PROPERTIES UNITY_BUILD OFF)
    target_compile_options(${code} PRIVATE -march=x86-64$<$<NOT:$<STREQUAL:${level},v1>>:-${level}>)
    target_compile_definitions(${code} PRIVATE OBBY_LANE_TABLE=${code})
    set(object ${CMAKE_CURRENT_BINARY_DIR}/${code}.o)
    add_custom_command(OUTPUT ${object}
      COMMAND ${PROJECT_SOURCE_DIR}/cmake/localize.sh ${CMAKE_LINKER} ${CMAKE_OBJCOPY} ${CMAKE_NM} ${code} ${object}
        $<TARGET_OBJECTS:${code}>
      DEPENDS ${code} $<TARGET_OBJECTS:${code}> ${PROJECT_SOURCE_DIR}/cmake/localize.sh
      COMMAND_EXPAND_LISTS VERBATIM COMMENT "Linking ${module}'s code for x86-64-${level}")
    target_sources(obby_${module} PRIVATE ${object})
    set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
  endforeach()
endfunction()
