# aobudget_texts(NAME FILE...): the files (GLSL, CSS, JavaScript) as the C texts aob_text_NAME_STEM, one for each, in
# "NAME/texts.h" of the folder generated/, by the target texts_NAME. So no program text stands in C strings.
function(aobudget_texts name)
  set(files "")
  foreach(file ${ARGN})
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    list(APPEND files ${file})
  endforeach()
  set(script ${CMAKE_SOURCE_DIR}/cmake/shaders.cmake)
  set(header ${CMAKE_BINARY_DIR}/generated/${name}/texts.h)
  add_custom_command(OUTPUT ${header} DEPENDS ${files} ${script} VERBATIM
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} "-DFILES=${files}" -DOUT=${header} -P ${script})
  add_custom_target(texts_${name} DEPENDS ${header})
endfunction()
