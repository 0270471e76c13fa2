# Node.js and the npm packages of a folder that has a package.json and a lock file.
find_program(OBBY_NODE NAMES node nodejs)
find_program(OBBY_NPM npm)

# obby_node_packages(reason): installs the locked packages of the current folder into its
# node_modules. Sets `reason` to the cause of a failure, or to an empty text.
function(obby_node_packages reason)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS package-lock.json)
  set(${reason} "" PARENT_SCOPE)
  if(NOT OBBY_NODE OR NOT OBBY_NPM)
    set(${reason} "node and npm were not found" PARENT_SCOPE)
    return()
  endif()
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env OBBY_NPM=${OBBY_NPM} ${OBBY_NODE}
      ${PROJECT_SOURCE_DIR}/cmake/npm_install.mjs ${CMAKE_CURRENT_SOURCE_DIR}
    RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(failed)
    message(STATUS "${log}")
    set(${reason} "npm could not install the packages of ${CMAKE_CURRENT_SOURCE_DIR} (see above)" PARENT_SCOPE)
  endif()
endfunction()
