# gpu-check: programs of the device library alone, so that one folder of them runs where neither VTK nor Embree nor assimp
# is (docs/gpu.md). What Debian has as an archive is linked from it; the rest (OpenEXRCore, zlib) is packed beside the
# program, which looks for it in its own lib/. C++'s library must be an archive: a driver brings its own, newer one.
add_library(aobudget_archives INTERFACE)
foreach(library jansson xxhash zstd)
  find_library(archive_${library} lib${library}.a REQUIRED)
  target_link_libraries(aobudget_archives INTERFACE ${archive_${library}})
endforeach()
# OpenEXRCore needs zlib and has no path to look along: the program itself must name it.
target_link_libraries(aobudget_archives INTERFACE -Wl,--push-state,--no-as-needed z -Wl,--pop-state)
target_link_options(aobudget_archives INTERFACE -static-libgcc -static-libstdc++ -Wl,--exclude-libs,ALL)

set(check ${CMAKE_SOURCE_DIR}/harness/gpu_check)
file(GLOB parts CONFIGURE_DEPENDS ${check}/*.c)
list(FILTER parts EXCLUDE REGEX "main\\.c$")
add_library(aobudget_gpu_check STATIC ${parts})
target_link_libraries(aobudget_gpu_check PUBLIC aobudget_device)
function(aobudget_packed_program name source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE aobudget_gpu_check)
  set_target_properties(${name} PROPERTIES AOBUDGET_PACKED ON RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}
    LINKER_LANGUAGE CXX BUILD_RPATH "$ORIGIN/lib")
endfunction()
aobudget_packed_program(gpu-check ${check}/main.c)
aobudget_packed_program(gpu-check-device ${check}/device_main.c)
aobudget_packed_program(gpu-check-data ${check}/data_main.c)
