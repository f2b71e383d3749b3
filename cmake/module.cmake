# Shared by the tree and, installed, by outside authors. aobudget_SHADERS_DIR is the folder that holds common/ and
# steps/.

# A module names every library that it uses, and finds its own functions before others of the same names, which the
# program and its libraries may have.
function(aobudget_link_module target)
  target_link_libraries(${target} PRIVATE m)
  target_link_options(${target} PRIVATE -Wl,-z,defs -Wl,-Bsymbolic)
endfunction()

# aobudget_shaders(NAME FOLDER STEP...): FOLDER/*.glsl and the texts of the steps as the table aob_shaders_NAME of
# generated/NAME/shaders.h, by the target shaders_NAME.
function(aobudget_shaders name folder)
  cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  file(GLOB texts CONFIGURE_DEPENDS ${folder}/*.glsl)
  file(GLOB common CONFIGURE_DEPENDS ${aobudget_SHADERS_DIR}/common/*.glsl ${aobudget_SHADERS_DIR}/steps/*.glsl)
  if(NOT texts)
    message(FATAL_ERROR "aobudget: ${name}: no *.glsl in ${folder}")
  endif()
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/shaders.cmake)
  set(header ${CMAKE_CURRENT_BINARY_DIR}/generated/${name}/shaders.h)
  add_custom_command(OUTPUT ${header} DEPENDS ${texts} ${common} ${script} VERBATIM
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DFOLDER=${folder} "-DSTEPS=${ARGN}" -DSHADERS=${aobudget_SHADERS_DIR}
            -DOUT=${header} -P ${script})
  add_custom_target(shaders_${name} DEPENDS ${header})
endfunction()

# aobudget_add_module(NAME SOURCES FILE.c... SHADERS FOLDER [STEPS STEP...]): NAME.so for --module. `#include
# "shaders.h"` in the sources finds the texts of FOLDER and of the steps (aobudget/steps.h) as aob_shaders_NAME.
function(aobudget_add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SHADERS" "SOURCES;STEPS")
  if(NOT arg_SOURCES OR NOT arg_SHADERS OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "aobudget_add_module(${name}): say "
      "aobudget_add_module(NAME SOURCES FILE.c... SHADERS FOLDER [STEPS STEP...])")
  endif()
  aobudget_shaders(${name} ${arg_SHADERS} ${arg_STEPS})
  add_library(${name} MODULE ${arg_SOURCES})
  add_dependencies(${name} shaders_${name})
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated/${name})
  target_link_libraries(${name} PRIVATE aobudget::technique)
  aobudget_link_module(${name})
  set_target_properties(${name} PROPERTIES PREFIX "")
endfunction()
