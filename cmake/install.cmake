# SPDX-License-Identifier: BSD-3-Clause
# Headers, licence and package files for find_package(pendular), in the installation and in the build folder.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# Nothing here is of one architecture.
set(package_folder "${CMAKE_INSTALL_DATADIR}/cmake/pendular")
set(version_file "${PROJECT_BINARY_DIR}/pendular-config-version.cmake")
# Before version 1 a new minor version may break what there was.
write_basic_package_version_file("${version_file}" COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)

install(TARGETS pendular EXPORT pendular-targets FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT pendular-targets NAMESPACE pendular:: DESTINATION "${package_folder}")
install(FILES "${PROJECT_SOURCE_DIR}/cmake/pendular-config.cmake" "${version_file}" DESTINATION "${package_folder}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/pendular")

export(EXPORT pendular-targets NAMESPACE pendular:: FILE "${PROJECT_BINARY_DIR}/pendular-targets.cmake")
configure_file("${PROJECT_SOURCE_DIR}/cmake/pendular-config.cmake" "${PROJECT_BINARY_DIR}/pendular-config.cmake" COPYONLY)
