# What the program af2 needs to load parts of af2::occ: an object library for the program, and one module for each
# part, which lies beside the program, or in lib/af2 once it is installed. af2_load_parts(TARGET) makes a program load
# them.

add_library(af2_part_loading OBJECT EXCLUDE_FROM_ALL
  occ/loading/loaded_readers.cpp occ/loading/loaded_algorithms.cpp occ/loading/reference_counts.cpp)
target_link_libraries(af2_part_loading PRIVATE af2_build af2_occ_headers af2::geometry)
target_compile_definitions(af2_part_loading PRIVATE
  AF2_VERSION="${PROJECT_VERSION}")

set(step_entry reader)
set(iges_entry reader)
set(algorithms_entry algorithms)
foreach(part ${loaded_parts})
  add_library(af2_${part}_module MODULE EXCLUDE_FROM_ALL occ/loading/${${part}_entry}_entry.cpp)
  target_compile_definitions(af2_${part}_module PRIVATE
    AF2_VERSION="${PROJECT_VERSION}")
  target_link_libraries(af2_${part}_module PRIVATE af2_build af2_occ_headers af2_${part})
  target_link_options(af2_${part}_module PRIVATE LINKER:-z,defs LINKER:-z,now LINKER:--as-needed)
  set_target_properties(af2_${part}_module PROPERTIES
    PREFIX "" OUTPUT_NAME af2-${part} AF2_LOADS_PARTS ON)
endforeach()
target_compile_definitions(af2_step_module PRIVATE AF2_MODULE_READER=readStep)
target_compile_definitions(af2_iges_module PRIVATE AF2_MODULE_READER=readIges)

function(af2_load_parts target)
  set_target_properties(${target} PROPERTIES AF2_LOADS_PARTS ON)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:af2_part_loading>)
  target_link_libraries(${target} PRIVATE ${CMAKE_DL_LIBS})
  target_link_options(${target} PRIVATE LINKER:--as-needed)
  foreach(module af2_step_module af2_iges_module af2_algorithms_module)
    add_dependencies(${target} ${module})
    set_target_properties(${module} PROPERTIES
      EXCLUDE_FROM_ALL FALSE LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
    install(TARGETS ${module} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/af2 COMPONENT program)
  endforeach()
endfunction()
