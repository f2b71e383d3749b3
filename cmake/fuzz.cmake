# The readers of files and their fuzz targets, with libFuzzer, which is clang's. Of the libraries only those that they call
# are needed, and nothing else is built.
find_package(OpenEXR 3.1 REQUIRED)
pkg_check_modules(JANSSON REQUIRED IMPORTED_TARGET jansson)
pkg_check_modules(YAML REQUIRED IMPORTED_TARGET yaml-0.1)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
# What clang says beyond gcc of the harness is no fault of a build that only ./dev fuzz makes.
add_compile_options(-Wno-error -Wno-sign-conversion -Wno-format-zero-length)
add_compile_options(-fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow -fno-sanitize-recover=all
  -fno-omit-frame-pointer)

file(GLOB READERS CONFIGURE_DEPENDS harness/base/*.c harness/config/*.c harness/profile/*.c harness/budget/*.c
  harness/store/image*.c harness/store/journal.c harness/scene/mesh.c harness/scene/mesh_material.c
  harness/scene/material.c)
add_library(fuzz_readers STATIC ${READERS} tests/fuzz/fuzz.c)
target_include_directories(fuzz_readers PUBLIC include harness tests/fuzz)
target_compile_definitions(fuzz_readers PUBLIC _GNU_SOURCE AOBUDGET_VERSION="${PROJECT_VERSION}")
target_link_libraries(fuzz_readers PUBLIC OpenEXR::OpenEXRCore PkgConfig::JANSSON PkgConfig::YAML PkgConfig::XXHASH m)

file(GLOB targets CONFIGURE_DEPENDS tests/fuzz/*.c)
list(FILTER targets EXCLUDE REGEX "/(fuzz|replay)\\.c$")
foreach(source ${targets})
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE fuzz_readers)
  target_link_options(${name} PRIVATE -fsanitize=fuzzer,address,undefined)
endforeach()
