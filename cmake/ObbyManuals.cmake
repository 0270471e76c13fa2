# obby_manual(tool): builds the tool's manual page and completion scripts, which the tool prints
# from its option table. They are part of ALL, lie in the build folder under man/ and completions/,
# and are installed where man and the shells search.
function(obby_manual tool)
  set(page ${PROJECT_BINARY_DIR}/man/${tool}.1)
  set(folder ${PROJECT_BINARY_DIR}/completions)
  add_custom_command(OUTPUT ${page} ${folder}/bash/${tool} ${folder}/zsh/_${tool} ${folder}/fish/${tool}.fish
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/man ${folder}/bash ${folder}/zsh ${folder}/fish
    COMMAND ${tool} --man > ${page}
    COMMAND ${tool} --completion bash > ${folder}/bash/${tool}
    COMMAND ${tool} --completion zsh > ${folder}/zsh/_${tool}
    COMMAND ${tool} --completion fish > ${folder}/fish/${tool}.fish
    COMMENT "Manual page and completions of ${tool}" VERBATIM)
  add_custom_target(${tool}-manual ALL DEPENDS ${page})
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${folder}/bash/${tool} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${folder}/zsh/_${tool} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
  install(FILES ${folder}/fish/${tool}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endfunction()
