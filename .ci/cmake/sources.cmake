# af2_sources(TARGET FOLDER... [EXCEPT FILE...]): all .cpp files of the folders belong to the target, so that
# a new file needs no line anywhere. They are compiled several at a time, because most of the time goes
# into headers, which the files of a folder have in common. With -DAF2_UNITY=OFF each file is compiled on
# its own.
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

# af2_cold_sources(TARGET FOLDER... [EXCEPT FILE...]): likewise, for what takes next to no time when the
# program runs. It is optimised less, which compiles in 0.6 of the time. To be called once the target
# has its libraries and definitions.
function(af2_cold_sources target)
  add_library(${target}_cold OBJECT)
  af2_sources(${target}_cold ${ARGN})
  foreach(property LINK_LIBRARIES COMPILE_DEFINITIONS INCLUDE_DIRECTORIES)
    get_target_property(values ${target} ${property})
    if(values)
      set_property(TARGET ${target}_cold PROPERTY ${property} ${values})
    endif()
  endforeach()
  target_compile_options(${target}_cold PRIVATE $<$<CONFIG:Release>:-O1>)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_cold>)
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
