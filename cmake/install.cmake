# What `cmake --install build/release --prefix P` lays down. All paths are relative to P: the folder may be moved.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_BINARY_DIR}/generated/package)
set_target_properties(aobudget-plot PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
install(TARGETS aobudget aobudget-plot RUNTIME DESTINATION bin)
install(TARGETS aoviz LIBRARY DESTINATION lib)
install(TARGETS ${BUILTIN_MODULES} LIBRARY DESTINATION lib/aobudget/modules)
install(DIRECTORY include/aobudget DESTINATION include FILES_MATCHING PATTERN "*.h")
install(DIRECTORY configs/budgets configs/papers configs/profiles DESTINATION share/aobudget FILES_MATCHING PATTERN "*.yaml")
install(DIRECTORY shaders/common shaders/steps DESTINATION share/aobudget/shaders FILES_MATCHING PATTERN "*.glsl")

configure_file(cmake/aobudget.pc.in ${package}/aobudget.pc @ONLY)
write_basic_package_version_file(${package}/aobudgetConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${package}/aobudget.pc DESTINATION lib/pkgconfig)
install(FILES cmake/aobudgetConfig.cmake cmake/module.cmake cmake/shaders.cmake
  ${package}/aobudgetConfigVersion.cmake DESTINATION lib/cmake/aobudget)
install(FILES ${CMAKE_SOURCE_DIR}/share/aobudget.1 DESTINATION share/man/man1)
install(FILES ${CMAKE_SOURCE_DIR}/share/aobudget.bash DESTINATION share/bash-completion/completions RENAME aobudget)
