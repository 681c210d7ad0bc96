# The writers of formats that need libraries of others: one module for each, on where CMake finds its library. They
# lie in the folder of AF2's libraries, from where they are loaded when such a file is asked for. The HDF5 that
# libmedc includes may be the one for MPI, which needs the headers of that.
include(CheckCXXSourceCompiles)
pkg_check_modules(AF2_HDF5 QUIET hdf5)
pkg_check_modules(AF2_MPI QUIET mpi)

# af2_writer_module(FORMAT FUNCTION HEADER LIBRARY INCLUDES...)
function(af2_writer_module format function header library)
  find_library(AF2_${library}_LIBRARY ${library})
  mark_as_advanced(AF2_${library}_LIBRARY)
  set(CMAKE_REQUIRED_INCLUDES ${ARGN})
  if(AF2_${library}_LIBRARY)
    check_cxx_source_compiles("#include <${header}>\nint main() {}" AF2_HAS_${library})
  endif()
  if(NOT AF2_HAS_${library})
    message(STATUS "AF2 does not write ${format} files: ${header} or ${library} was not found")
    return()
  endif()
  set(target af2_${format}_writer)
  add_library(${target} MODULE formats/modules/writer_entry.cpp formats/format_names.cpp formats/${format}/write_${format}.cpp)
  target_compile_definitions(${target} PRIVATE AF2_VERSION="${PROJECT_VERSION}" AF2_MODULE_WRITER=${function})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O2>)
  target_include_directories(${target} SYSTEM PRIVATE ${ARGN})
  target_link_libraries(${target} PRIVATE af2_build ${AF2_${library}_LIBRARY})
  target_link_options(${target} PRIVATE LINKER:--as-needed)
  if(NOT AF2_BUILD_FUZZERS)  # Clang's sanitizers are defined in the program alone
    target_link_options(${target} PRIVATE LINKER:-z,defs)
  endif()
  set_target_properties(${target} PROPERTIES PREFIX "" OUTPUT_NAME af2-${format}
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/af2)
  add_dependencies(af2_geometry ${target})
  install(TARGETS ${target} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/af2 COMPONENT formats)
endfunction()

af2_writer_module(med writeMedFile med.h medC ${AF2_HDF5_INCLUDE_DIRS} ${AF2_MPI_INCLUDE_DIRS})
af2_writer_module(exodus writeExodusFile exodusII.h exoIIv2c)
af2_writer_module(cgns writeCgnsFile cgnslib.h cgns)
