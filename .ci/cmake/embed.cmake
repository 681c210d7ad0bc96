# af2_embed(TARGET NAME FOLDER FILE...): the target contains these files of the folder: NAME.inc, which it can include,
# lists them as {"FILE", R"(content)"}. A change of a file makes the list again.
function(af2_embed target name folder)
  set(parts "")
  foreach(part ${ARGN})
    set(part_file "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${part}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${part_file}")
    file(READ "${part_file}" text)
    string(APPEND parts "{\"${part}\", R\"af2part(${text})af2part\"},\n")
  endforeach()
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/${name}.txt" "${parts}")
  configure_file("${CMAKE_CURRENT_BINARY_DIR}/${name}.txt"
    "${CMAKE_CURRENT_BINARY_DIR}/generated/${name}.inc" COPYONLY)
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/generated")
endfunction()
