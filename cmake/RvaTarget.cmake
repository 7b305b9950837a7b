# Flags and rules that every target of ours shares.

add_library(rva_flags INTERFACE)
target_compile_options(rva_flags INTERFACE -Wall -Wextra -Wconversion -Wshadow -Werror)
# The detectors promise to agree with the thesis' formulas to the last bit: a product and a sum are
# rounded apart, never fused.
target_compile_options(rva_flags INTERFACE -ffp-contract=off)
if(RVA_SANITIZE)
  target_compile_options(rva_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                             -fno-omit-frame-pointer)
  target_link_options(rva_flags INTERFACE -fsanitize=address,undefined)
endif()
if(RVA_SANITIZE_THREADS)
  # GCC 12 takes what it instruments here for uninitialised.
  target_compile_options(rva_flags INTERFACE -fsanitize=thread -O1 -fno-omit-frame-pointer
                                             -Wno-maybe-uninitialized)
  target_link_options(rva_flags INTERFACE -fsanitize=thread)
endif()
if(RVA_FUZZ)
  target_compile_options(rva_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# rva_library(NAME [SOURCES ...] [LINKS ...]): one folder of src/, one static library.
# What a folder may link is the folder order of docs/design.md; tests/architecture holds the includes to it.
function(rva_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PUBLIC ${ARG_LINKS} PRIVATE rva_flags)
endfunction()

# OpenCV's headers are not clean under -Wconversion; they are not ours to mend.
add_library(rva_opencv INTERFACE)
target_include_directories(rva_opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
target_link_libraries(rva_opencv INTERFACE opencv_core opencv_imgproc)

# Nor are PCL's.
add_library(rva_pcl INTERFACE)
target_include_directories(rva_pcl SYSTEM INTERFACE ${PCL_INCLUDE_DIRS})
target_link_libraries(rva_pcl INTERFACE pcl_common pcl_kdtree pcl_octree pcl_registration pcl_search)

# The thread sanitizer does not see fences, which Asio has; it has locks beside them, which are seen.
function(rva_has_fences name)
  if(RVA_SANITIZE_THREADS)
    target_compile_options(${name} PRIVATE -Wno-tsan)
  endif()
endfunction()
