# What `cmake --install` copies besides the libraries and their headers (RvaTarget.cmake).

install(TARGETS rva RUNTIME COMPONENT program)

# script/console builds it, whatever the preset. The program looks for it beside itself (src/cli/console_folder.cpp).
set(console ${PROJECT_SOURCE_DIR}/build/console)
install(DIRECTORY ${console}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/rva/console COMPONENT program OPTIONAL)
install(CODE "
  if(NOT EXISTS \"${console}/index.html\")
    message(STATUS \"The console is not installed, since it is not built: script/console builds it.\")
  endif()" COMPONENT program)

foreach(component program library)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/rva COMPONENT ${component})
endforeach()

# The package for find_package(rva).
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/rva)
install(EXPORT rvaTargets NAMESPACE rva:: DESTINATION ${package} COMPONENT library)
get_property(RVA_COMPONENTS GLOBAL PROPERTY RVA_COMPONENTS)
configure_file(${PROJECT_SOURCE_DIR}/cmake/rvaConfig.cmake.in ${PROJECT_BINARY_DIR}/rvaConfig.cmake @ONLY)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rvaConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rvaConfig.cmake ${PROJECT_BINARY_DIR}/rvaConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/rvaDependencies.cmake
        DESTINATION ${package} COMPONENT library)
