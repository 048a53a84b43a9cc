# What `cmake --install` puts where: the program with its manual page and completion, and the
# libraries as a package for find_package(brachium).
include(CMakePackageConfigHelpers)

set(shared ${CMAKE_BINARY_DIR}/share)
file(MAKE_DIRECTORY ${shared})
add_custom_command(TARGET brachium POST_BUILD
  COMMAND brachium man > ${shared}/brachium.1
  COMMAND brachium completion > ${shared}/brachium)
install(TARGETS brachium RUNTIME DESTINATION bin)
install(FILES ${shared}/brachium.1 DESTINATION share/man/man1)
install(FILES ${shared}/brachium DESTINATION share/bash-completion/completions)

set(package ${CMAKE_BINARY_DIR}/package)
list(TRANSFORM library_needs REPLACE "(.+)" "find_dependency(\\1)" OUTPUT_VARIABLE find_dependencies)
list(JOIN find_dependencies "\n" find_dependencies)
configure_file(${CMAKE_CURRENT_LIST_DIR}/brachium-config.cmake.in
  ${package}/brachium-config.cmake @ONLY)
write_basic_package_version_file(${package}/brachium-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${package}/brachium-config.cmake ${package}/brachium-config-version.cmake
  DESTINATION lib/cmake/brachium)
install(TARGETS brachium_problems brachium_solver brachium_io EXPORT brachium
  ARCHIVE DESTINATION lib)
install(EXPORT brachium NAMESPACE brachium:: FILE brachium-targets.cmake
  DESTINATION lib/cmake/brachium)
install(DIRECTORY problems solver io DESTINATION include/brachium
  FILES_MATCHING PATTERN "*.h")
