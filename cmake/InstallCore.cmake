# Installs the core as a library: headers in include/patchmill, and what find_package(PatchMill) reads. Beside the FreeCAD
# module it is a component of its own, which a plain `cmake --install` leaves out:
#     cmake --install build --component library --prefix DIR
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(LIBRARY_COMPONENT COMPONENT library)
if(PATCHMILL_HOST)
  list(APPEND LIBRARY_COMPONENT EXCLUDE_FROM_ALL)
endif()
set(PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/PatchMill)

install(TARGETS patchmill_core EXPORT PatchMillTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ${LIBRARY_COMPONENT})
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/src/core/patchmill DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        ${LIBRARY_COMPONENT} FILES_MATCHING PATTERN "*.h"
        # parts of flute_lanes_*.cpp, compiled once for each instruction set with a name given from outside
        REGEX "/flute_(lanes|newton|rows|search)\\.h$" EXCLUDE)
install(EXPORT PatchMillTargets NAMESPACE PatchMill:: DESTINATION ${PACKAGE_DIR} ${LIBRARY_COMPONENT})
configure_package_config_file(${CMAKE_CURRENT_SOURCE_DIR}/cmake/PatchMillConfig.cmake.in
                              ${CMAKE_CURRENT_BINARY_DIR}/PatchMillConfig.cmake
                              INSTALL_DESTINATION ${PACKAGE_DIR})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/PatchMillConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/PatchMillConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/PatchMillConfigVersion.cmake
        DESTINATION ${PACKAGE_DIR} ${LIBRARY_COMPONENT})
