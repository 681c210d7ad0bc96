# What the program af2 needs to load the readers of STEP and IGES files: an object library for the program,
# and one module for each format, which lies beside the program, or in lib/af2 once it is installed.
# af2_load_readers(TARGET) makes a program load them.

add_library(af2_reader_loading OBJECT EXCLUDE_FROM_ALL occ/loading/loaded_readers.cpp)
target_link_libraries(af2_reader_loading PRIVATE af2_build af2_occ_headers af2::geometry)
target_compile_definitions(af2_reader_loading PRIVATE
  AF2_VERSION="${PROJECT_VERSION}")

foreach(format step iges)
  string(TOUPPER ${format} upper)
  string(SUBSTRING ${upper} 0 1 first)
  string(SUBSTRING ${format} 1 -1 rest)
  add_library(af2_${format}_module MODULE EXCLUDE_FROM_ALL occ/loading/reader_entry.cpp)
  target_compile_definitions(af2_${format}_module PRIVATE
    AF2_VERSION="${PROJECT_VERSION}" AF2_MODULE_READER=read${first}${rest})
  target_link_libraries(af2_${format}_module PRIVATE af2_build af2_occ_headers af2_${format})
  target_link_options(af2_${format}_module PRIVATE LINKER:-z,defs LINKER:--as-needed)
  set_target_properties(af2_${format}_module PROPERTIES
    PREFIX "" OUTPUT_NAME af2-${format} AF2_LOADS_READERS ON)
  list(TRANSFORM ${format}_libraries REPLACE "(.+)" "$<TARGET_SONAME_FILE_NAME:\\1>"
    OUTPUT_VARIABLE names)
  list(JOIN names " " names)
  target_compile_definitions(af2_reader_loading PRIVATE AF2_NEEDED_BY_${upper}="${names}")
endforeach()

function(af2_load_readers target)
  set_target_properties(${target} PROPERTIES AF2_LOADS_READERS ON)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:af2_reader_loading>)
  target_link_libraries(${target} PRIVATE ${CMAKE_DL_LIBS})
  target_link_options(${target} PRIVATE LINKER:--as-needed)
  foreach(module af2_step_module af2_iges_module)
    add_dependencies(${target} ${module})
    set_target_properties(${module} PROPERTIES
      EXCLUDE_FROM_ALL FALSE LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
    install(TARGETS ${module} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/af2 COMPONENT program)
  endforeach()
endfunction()
