# What makes find_package(af2) work: from an install, with the components engine, dsl, geometry, occ.
include(CMakePackageConfigHelpers)

set(AF2_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/af2)
set(AF2_RULES_DIR ${CMAKE_INSTALL_DATADIR}/af2/rules)

configure_package_config_file(cmake/af2-config.cmake.in af2-config.cmake
  INSTALL_DESTINATION ${AF2_CMAKE_DIR} PATH_VARS AF2_RULES_DIR)
write_basic_package_version_file(af2-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/af2-config.cmake ${PROJECT_BINARY_DIR}/af2-config-version.cmake
  DESTINATION ${AF2_CMAKE_DIR})
install(EXPORT af2-targets NAMESPACE af2:: DESTINATION ${AF2_CMAKE_DIR})
install(DIRECTORY rules/ DESTINATION ${AF2_RULES_DIR} FILES_MATCHING PATTERN "*.af2")
install(FILES LICENSE COPYING NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
