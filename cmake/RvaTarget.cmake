# Flags and rules for all targets of the project.

add_library(rva_flags INTERFACE)
# Warnings of another compiler do not stop the build of a project that embeds RVA.
target_compile_options(rva_flags INTERFACE -Wall -Wextra -Wconversion -Wshadow $<$<BOOL:${PROJECT_IS_TOP_LEVEL}>:-Werror>)
# The results of the detectors must equal those of the thesis' formulas to the last bit, so a product and a sum
# are rounded separately and never fused.
target_compile_options(rva_flags INTERFACE -ffp-contract=off)
if(RVA_SANITIZE)
  target_compile_options(rva_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
  target_link_options(rva_flags INTERFACE -fsanitize=address,undefined)
endif()
if(RVA_SANITIZE_THREADS)
  # GCC 12 reports instrumented variables as uninitialised.
  target_compile_options(rva_flags INTERFACE -fsanitize=thread -O1 -fno-omit-frame-pointer
                                             -Wno-maybe-uninitialized)
  target_link_options(rva_flags INTERFACE -fsanitize=thread)
endif()
if(RVA_FUZZ)
  target_compile_options(rva_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# The Python module is a shared library that contains the libraries. Their functions are called directly, and inlined, as
# in a program: none of them is to be replaced by another library's.
function(rva_may_be_shared name)
  if(RVA_PYTHON_MODULE)
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${name} PRIVATE -fno-semantic-interposition)
  endif()
endfunction()

# Headers that most files include, compiled once: Eigen alone takes a third of the time of an average file.
add_library(rva_precompiled OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
target_link_libraries(rva_precompiled PRIVATE rva_flags Eigen3::Eigen fmt::fmt)
rva_may_be_shared(rva_precompiled)
target_precompile_headers(rva_precompiled PRIVATE
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span> <string> <vector>
  <Eigen/Core> <Eigen/Geometry> <fmt/format.h>)

# rva_library(NAME [SOURCES ...] [LINKS ...]): builds one folder of src/ as a static library, rva_FOLDER. Other projects
# link to it as rva::FOLDER.
# docs/design.md defines which folders a folder may link; tests/architecture checks that the includes conform.
function(rva_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  string(REGEX REPLACE "^rva_" "" folder ${name})
  add_library(${name} STATIC ${ARG_SOURCES})
  add_library(rva::${folder} ALIAS ${name})
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/rva>)
  target_link_libraries(${name} PUBLIC ${ARG_LINKS} PRIVATE $<BUILD_INTERFACE:rva_flags>)
  # For the precompiled headers. A folder whose own headers include them has them among its LINKS.
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:Eigen3::Eigen> $<BUILD_INTERFACE:fmt::fmt>)
  rva_may_be_shared(${name})
  target_precompile_headers(${name} REUSE_FROM rva_precompiled)
  set_target_properties(${name} PROPERTIES EXPORT_NAME ${folder})
  set_property(GLOBAL APPEND PROPERTY RVA_COMPONENTS ${folder})
  if(RVA_INSTALL)
    install(TARGETS ${name} EXPORT rvaTargets ARCHIVE COMPONENT library)
    install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rva/${folder}
            COMPONENT library FILES_MATCHING PATTERN *.hpp)
  endif()
endfunction()

# Disables GCC's warning that the thread sanitizer does not support fences. Asio uses fences, but also locks, which the
# sanitizer does support.
function(rva_has_fences name)
  if(RVA_SANITIZE_THREADS)
    target_compile_options(${name} PRIVATE -Wno-tsan)
  endif()
endfunction()
