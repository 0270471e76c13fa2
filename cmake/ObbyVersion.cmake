# The commit that programs print for --version, in obby_commit, a library of one generated file.
# Each build asks git and writes the file only if the commit has changed. Then only this file is
# compiled and the programs are linked again. As a script (cmake -D SOURCE_DIR=... -D OUTPUT=... -D
# COMMIT=... -P ObbyVersion.cmake) it writes the file.
if(CMAKE_SCRIPT_MODE_FILE)
  cmake_minimum_required(VERSION 3.25)
  if(COMMIT STREQUAL "")
    # Only if the checkout is obby's own; the folder may lie inside another repository.
    execute_process(COMMAND git -C ${SOURCE_DIR} rev-parse --show-toplevel --short=10 HEAD
      OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    if(failed STREQUAL "0" AND answer MATCHES "^(.*)\n([0-9a-f]+)$")
      file(REAL_PATH ${SOURCE_DIR} here)
      set(commit_found ${CMAKE_MATCH_2})
      file(REAL_PATH ${CMAKE_MATCH_1} top)
      if(here STREQUAL top)
        set(COMMIT ${commit_found})
      endif()
    endif()
  endif()
  set(text "// Written by cmake/ObbyVersion.cmake.\nnamespace obby::cli {\nextern const char* const kCommit;
const char* const kCommit = \"${COMMIT}\";\n}  // namespace obby::cli\n")
  set(before)
  if(EXISTS ${OUTPUT})
    file(READ ${OUTPUT} before)
  endif()
  if(NOT text STREQUAL before)
    file(WRITE ${OUTPUT} "${text}")
  endif()
  return()
endif()

set(OBBY_COMMIT "" CACHE STRING "The commit that --version names; empty: the one that git says at build time, if any")
set(commit_source ${PROJECT_BINARY_DIR}/generated/commit.cpp)
add_custom_target(obby_commit_source BYPRODUCTS ${commit_source} VERBATIM
  COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR} -D OUTPUT=${commit_source} -D COMMIT=${OBBY_COMMIT}
    -P ${CMAKE_CURRENT_LIST_FILE}
  COMMENT "Commit for --version")
add_library(obby_commit STATIC ${commit_source})
add_library(obby::commit ALIAS obby_commit)
add_dependencies(obby_commit obby_commit_source)
