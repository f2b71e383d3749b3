# find_package(aobudget): the target aobudget::technique (headers for a module), the function aobudget_add_module,
# aobudget_SHADERS_DIR (holds common/), aobudget_MODULES_DIR (the built-ins as .so), aobudget_PROGRAM.
get_filename_component(aobudget_PREFIX "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(aobudget_SHADERS_DIR "${aobudget_PREFIX}/share/aobudget/shaders")
set(aobudget_MODULES_DIR "${aobudget_PREFIX}/lib/aobudget/modules")
set(aobudget_PROGRAM "${aobudget_PREFIX}/bin/aobudget")
if(NOT TARGET aobudget::technique)
  add_library(aobudget::technique INTERFACE IMPORTED)
  target_include_directories(aobudget::technique INTERFACE "${aobudget_PREFIX}/include")
  target_compile_features(aobudget::technique INTERFACE c_std_11)
endif()
include("${CMAKE_CURRENT_LIST_DIR}/module.cmake")
