# Installs pliant::core for find_package(pliant): the archive, the headers of core/pliant under include/pliant and the package.
# PLIANT_INSTALLABLE tells the tests whether there is anything to install.
get_property(fetched GLOBAL PROPERTY PLIANT_FETCHED)
set(PLIANT_INSTALLABLE ON CACHE INTERNAL "")
foreach(package Eigen3 fmt nlohmann_json pugixml TBB)
  if(package IN_LIST fetched)
    message(STATUS "install: left out, for an installed pliant::core needs ${package} installed too")
    set(PLIANT_INSTALLABLE OFF CACHE INTERNAL "")
    return()
  endif()
endforeach()

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pliant)

install(TARGETS pliant_core EXPORT pliantTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT pliant_core)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/pliant DESTINATION include COMPONENT pliant_core FILES_MATCHING PATTERN "*.h")
install(EXPORT pliantTargets NAMESPACE pliant:: DESTINATION ${package_dir} COMPONENT pliant_core)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/pliantConfig.cmake.in ${PROJECT_BINARY_DIR}/package/pliantConfig.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/pliantConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(
  FILES ${PROJECT_BINARY_DIR}/package/pliantConfig.cmake ${PROJECT_BINARY_DIR}/package/pliantConfigVersion.cmake
  DESTINATION ${package_dir}
  COMPONENT pliant_core)
