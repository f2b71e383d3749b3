# A technique is a folder in techniques/ and one of the same name in shaders/: nothing else names it. Each becomes a
# part of the program and a module of its own in modules/. The words of techniques/NAME/steps.txt, where there is one,
# are the steps that it uses. What stands in APART is no technique for ambient occlusion: a module only.
set(APART deferred)
file(GLOB folders CONFIGURE_DEPENDS LIST_DIRECTORIES true RELATIVE ${CMAKE_SOURCE_DIR}/techniques
     ${CMAKE_SOURCE_DIR}/techniques/*)
list(SORT folders)
set(aobudget_SHADERS_DIR ${CMAKE_SOURCE_DIR}/shaders)
include(${CMAKE_CURRENT_LIST_DIR}/module.cmake)

set(declarations "")
set(rows "")
foreach(name ${folders})
  set(steps "")
  if(EXISTS ${CMAKE_SOURCE_DIR}/techniques/${name}/steps.txt)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS techniques/${name}/steps.txt)
    file(STRINGS techniques/${name}/steps.txt steps)
    separate_arguments(steps)
  endif()
  aobudget_shaders(${name} shaders/${name} ${steps})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/techniques/${name}/*.c)
  add_library(technique_${name} OBJECT ${sources})
  target_include_directories(technique_${name} PRIVATE include ${CMAKE_BINARY_DIR}/generated/${name})
  add_dependencies(technique_${name} shaders_${name})
  if(NOT name IN_LIST APART)
    list(APPEND BUILTIN_OBJECTS $<TARGET_OBJECTS:technique_${name}>)
    string(APPEND declarations "extern const struct aob_technique aob_technique_${name};\n")
    string(APPEND rows "    &aob_technique_${name},\n")
  endif()

  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/${name}/module.c @ONLY CONTENT
"#include <aobudget/technique.h>\nextern const struct aob_technique aob_technique_${name};\nAOB_MODULE(&aob_technique_${name});\n")
  add_library(module_${name} MODULE $<TARGET_OBJECTS:technique_${name}> ${CMAKE_BINARY_DIR}/generated/${name}/module.c)
  target_include_directories(module_${name} PRIVATE include)
  aobudget_link_module(module_${name})
  set_target_properties(module_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name}
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/modules)
  list(APPEND BUILTIN_MODULES module_${name})
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/builtin.c @ONLY CONTENT
"/* Written by the build from the folders in techniques/. */
#include \"technique/registry.h\"\n${declarations}
const struct aob_technique *const aob_builtin_techniques[] = {\n${rows}    NULL,\n};\n")
list(APPEND BUILTIN_OBJECTS ${CMAKE_BINARY_DIR}/generated/builtin.c)

# The fixed pass that every block is timed against: laid out like a technique, listed nowhere.
aobudget_shaders(fixed_pass shaders/fixed_pass)

# The harness's own passes, behind a technique's and before them (harness/technique/composite.h, clearance.h).
aobudget_shaders(composite shaders/composite)
aobudget_shaders(clearance shaders/clearance)
