# Install rules and the CMake package with which other projects find TOSS.

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/toss)

install(TARGETS toss)
install(DIRECTORY config/ DESTINATION ${CMAKE_INSTALL_DATADIR}/toss/config)
install(EXPORT toss-targets NAMESPACE toss:: DESTINATION ${package_dir})
configure_package_config_file(share/cmake/toss-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/toss-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/toss-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/toss-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/toss-config-version.cmake DESTINATION ${package_dir})
