# Flags and rules for all targets of the project.

add_library(rva_flags INTERFACE)
target_compile_options(rva_flags INTERFACE -Wall -Wextra -Wconversion -Wshadow -Werror)
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

# Headers that most files include, compiled once: Eigen alone takes a third of the time of an average file.
add_library(rva_precompiled OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
target_link_libraries(rva_precompiled PRIVATE rva_flags Eigen3::Eigen fmt::fmt)
target_precompile_headers(rva_precompiled PRIVATE
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span> <string> <vector>
  <Eigen/Core> <Eigen/Geometry> <fmt/format.h>)

# rva_library(NAME [SOURCES ...] [LINKS ...]): builds one folder of src/ as a static library.
# docs/design.md defines which folders a folder may link; tests/architecture checks that the includes conform.
function(rva_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PUBLIC ${ARG_LINKS} PRIVATE rva_flags Eigen3::Eigen fmt::fmt)
  target_precompile_headers(${name} REUSE_FROM rva_precompiled)
endfunction()

# OpenCV's headers cause warnings under -Wconversion, so they are included as system headers.
add_library(rva_opencv INTERFACE)
target_include_directories(rva_opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
target_link_libraries(rva_opencv INTERFACE opencv_core opencv_imgproc)

# PCL's headers are included as system headers for the same reason.
add_library(rva_pcl INTERFACE)
target_include_directories(rva_pcl SYSTEM INTERFACE ${PCL_INCLUDE_DIRS})
target_link_libraries(rva_pcl INTERFACE pcl_common pcl_kdtree pcl_octree pcl_registration pcl_search)

# Disables GCC's warning that the thread sanitizer does not support fences. Asio uses fences, but also locks, which the
# sanitizer does support.
function(rva_has_fences name)
  if(RVA_SANITIZE_THREADS)
    target_compile_options(${name} PRIVATE -Wno-tsan)
  endif()
endfunction()
