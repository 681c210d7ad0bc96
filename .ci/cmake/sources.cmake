# af2_sources(TARGET FOLDER... [EXCEPT FILE...]): all .cpp files of the folders belong to the target, so that a
# new file needs no line anywhere. They are compiled a few at a time: most of the time goes into
# headers, which the files of a folder have in common.
#
# With -DAF2_UNITY=OFF each file is compiled on its own, for those who change many of them often.
option(AF2_UNITY "Compile several files of a folder together" ON)
set(AF2_FILES_TOGETHER 10 CACHE STRING "How many files are compiled together")
mark_as_advanced(AF2_FILES_TOGETHER)

function(af2_sources target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" EXCEPT)
  foreach(folder ${arg_UNPARSED_ARGUMENTS})
    file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
    foreach(file ${arg_EXCEPT})
      list(REMOVE_ITEM files ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    endforeach()
    target_sources(${target} PRIVATE ${files})
    af2_compile_together(${target} ${folder} ${files})
  endforeach()
endfunction()

# Groups of equal size: seven and seven rather than ten and four.
function(af2_compile_together target folder)
  if(NOT AF2_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  list(LENGTH ARGN count)
  math(EXPR groups "(${count} + ${AF2_FILES_TOGETHER} - 1) / ${AF2_FILES_TOGETHER}")
  string(MAKE_C_IDENTIFIER ${folder} name)
  set(index 0)
  foreach(file ${ARGN})
    math(EXPR group "${index} * ${groups} / ${count}")
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${name}_${group})
    math(EXPR index "${index} + 1")
  endforeach()
endfunction()
