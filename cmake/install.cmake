# `cmake --install` and `cpack`. The program finds its data beside itself (renderer/core/data_folder.h), so that what is
# installed may be moved. Component "program" is all that a distribution needs; "libraries" is added to the portable
# archive: what machines lack, but for the C and C++ runtimes and the OpenGL driver.
include(GNUInstallDirs)
set(data share/timeshade)
# Not RUNPATH: that would not hold for what the libraries themselves need.
set_target_properties(timeshade PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/timeshade")
target_link_options(timeshade PRIVATE -Wl,--disable-new-dtags)

# The manual page and what shells complete with: made of the program's own declarations of its options.
set(help_files)
function(timeshade_help file arguments)
  set(path ${PROJECT_BINARY_DIR}/help/${file})
  add_custom_command(OUTPUT ${path} DEPENDS timeshade VERBATIM
                     COMMAND sh -c "$<TARGET_FILE:timeshade> help ${arguments} > ${path}.part"
                     COMMAND ${CMAKE_COMMAND} -E rename ${path}.part ${path})
  set(help_files ${help_files} ${path} PARENT_SCOPE)
endfunction()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/help)
timeshade_help(timeshade.1 "--man")
timeshade_help(timeshade.bash "--completion bash")
timeshade_help(_timeshade "--completion zsh")
timeshade_help(timeshade.fish "--completion fish")
add_custom_target(timeshade_help ALL DEPENDS ${help_files})

install(TARGETS timeshade RUNTIME COMPONENT program)
install(PROGRAMS scripts/gpu_check.sh DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME timeshade-gpu-check COMPONENT program)
install(DIRECTORY shaders DESTINATION ${data} COMPONENT program)
install(DIRECTORY assets/scenes assets/papers DESTINATION ${data}/assets COMPONENT program)
install(FILES assets/demo.json assets/story.json assets/SOURCES.md DESTINATION ${data}/assets COMPONENT program)
install(DIRECTORY renderer/techniques DESTINATION ${data}/renderer COMPONENT program
        FILES_MATCHING PATTERN page.png)
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program FILES_MATCHING PATTERN "*.md")
install(FILES ${PROJECT_BINARY_DIR}/help/timeshade.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES cmake/package/timeshade.desktop DESTINATION share/applications COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/help/timeshade.bash DESTINATION share/bash-completion/completions RENAME timeshade
        COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/help/_timeshade DESTINATION share/zsh/site-functions COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/help/timeshade.fish DESTINATION share/fish/vendor_completions.d COMPONENT program)

install(CODE [[
  file(GET_RUNTIME_DEPENDENCIES EXECUTABLES $<TARGET_FILE:timeshade>
       RESOLVED_DEPENDENCIES_VAR libraries
       PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|pthread|rt|stdc\\+\\+|gcc_s|z|EGL|GL|OpenGL|GLdispatch)\\.so")
  file(INSTALL ${libraries} DESTINATION "${CMAKE_INSTALL_PREFIX}/lib/timeshade" FOLLOW_SYMLINK_CHAIN)
]] COMPONENT libraries EXCLUDE_FROM_ALL)
find_path(DEJAVU_FONTS DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu REQUIRED)
install(FILES ${DEJAVU_FONTS}/DejaVuSans.ttf ${DEJAVU_FONTS}/DejaVuSans-Bold.ttf DESTINATION ${data}/fonts
        COMPONENT libraries EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME timeshade)
set(CPACK_PACKAGE_CONTACT "Timeshade")
set(CPACK_PACKAGE_FILE_NAME timeshade-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package/components.cmake)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libosmesa6")
include(CPack)
