# What `cmake --install` lays below a prefix: the executable, configurations with their schemas and data, documentation, manual and completions.
# The program finds configurations relative to itself (app/installation.hpp), so the prefix may be moved.
set(asperity_share share/asperity)
set(asperity_doc share/doc/asperity)

install(TARGETS asperity RUNTIME DESTINATION bin)

# Configurations name each other, their data and their schemas by relative paths: the folder stays as it is.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs DESTINATION ${asperity_share})

# The documents keep their folders, so that links between them lead somewhere.
file(GLOB_RECURSE documents CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/docs/* ${PROJECT_SOURCE_DIR}/core/*.md
     ${PROJECT_SOURCE_DIR}/render/*.md ${PROJECT_SOURCE_DIR}/tests/*.md)
foreach(document README.md CHANGELOG.md outputs/README.md ${documents})
  get_filename_component(folder ${document} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${document} DESTINATION ${asperity_doc}/${folder})
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/cmake/debian/copyright DESTINATION ${asperity_doc})
install(CODE "file(CREATE_LINK ../../asperity/configs \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${asperity_doc}/examples\" SYMBOLIC)")

# The executable writes its manual and completions itself, so they cannot be those of another version.
install(CODE "
  set(asperity \"$<TARGET_FILE:asperity>\")
  set(written \"${CMAKE_BINARY_DIR}/installed_documents\")
")
install(CODE [[
  file(MAKE_DIRECTORY ${written})
  execute_process(COMMAND ${asperity} manual OUTPUT_FILE ${written}/asperity.1 COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND gzip -9nf ${written}/asperity.1 COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${asperity} completion bash OUTPUT_FILE ${written}/asperity COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${asperity} completion zsh OUTPUT_FILE ${written}/_asperity COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${asperity} completion fish OUTPUT_FILE ${written}/asperity.fish COMMAND_ERROR_IS_FATAL ANY)
  set(share ${CMAKE_INSTALL_PREFIX}/share)
  # Debian's zsh reads vendor-completions below /usr, site-functions below any other prefix.
  set(zsh_folder site-functions)
  if(CMAKE_INSTALL_PREFIX MATCHES "/usr$")
    set(zsh_folder vendor-completions)
  endif()
  file(INSTALL ${written}/asperity.1.gz DESTINATION ${share}/man/man1)
  file(INSTALL ${written}/asperity DESTINATION ${share}/bash-completion/completions)
  file(INSTALL ${written}/_asperity DESTINATION ${share}/zsh/${zsh_folder})
  file(INSTALL ${written}/asperity.fish DESTINATION ${share}/fish/vendor_completions.d)
]])
