# Bound copies of OpenCASCADE's libraries: bound_library.h. Whenever a program starts, Debian's libraries are searched
# for each of their own symbols, which takes longer than to mesh a small model. af2_use_bound_libraries(TARGET) lets a
# program that has called af2_load_parts use copies in ../lib/af2/occ, seen from the program, in the build as after the
# install. Where there are none, it uses the libraries of the system.
#
# Packages do not contain the copies: they are made when the package is installed, and again when OpenCASCADE's
# libraries are (.ci/cmake/packages.cmake).
set(can_bind OFF)
if(CMAKE_SYSTEM_NAME STREQUAL Linux AND CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64 AND NOT CMAKE_CROSSCOMPILING)
  set(can_bind ON)
endif()
option(AF2_BIND_LIBRARIES "Let the program af2 use copies of OpenCASCADE's libraries that load faster" ${can_bind})

set(bound_libraries ${shape_libraries} ${step_libraries} ${iges_libraries} ${algorithms_libraries})
list(REMOVE_DUPLICATES bound_libraries)
list(TRANSFORM bound_libraries REPLACE "(.+)" "$<TARGET_SONAME_FILE:\\1>")

add_library(af2_binding STATIC EXCLUDE_FROM_ALL occ/binding/bound_library.cpp)
target_link_libraries(af2_binding PRIVATE af2_build)
add_executable(af2_bind_libraries EXCLUDE_FROM_ALL occ/binding/bind_libraries.cpp)
target_link_libraries(af2_bind_libraries PRIVATE af2_build af2_binding)
set_target_properties(af2_bind_libraries PROPERTIES
  OUTPUT_NAME bind-libraries AF2_LIBRARIES "${bound_libraries}")

function(af2_use_bound_libraries target)
  if(NOT AF2_BIND_LIBRARIES)
    return()
  endif()
  get_target_property(libraries af2_bind_libraries AF2_LIBRARIES)
  set(place ${CMAKE_INSTALL_LIBDIR}/af2/occ)
  set(folder ${PROJECT_BINARY_DIR}/${place})
  add_custom_command(OUTPUT ${folder}.stamp
    COMMAND af2_bind_libraries ${folder} ${libraries}
    COMMAND ${CMAKE_COMMAND} -E touch ${folder}.stamp
    DEPENDS af2_bind_libraries ${libraries} VERBATIM)
  add_custom_target(${target}_libraries DEPENDS ${folder}.stamp)
  add_dependencies(${target} ${target}_libraries)
  # In the older way, which holds for the libraries that these libraries need, too.
  target_link_options(${target} PRIVATE LINKER:--disable-new-dtags)
  file(RELATIVE_PATH from_program /${CMAKE_INSTALL_BINDIR} /${place})
  set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${from_program}" BUILD_WITH_INSTALL_RPATH ON)
  # A component that no package has.
  install(DIRECTORY ${folder}/ DESTINATION ${place} COMPONENT bound)
  install(TARGETS af2_bind_libraries DESTINATION ${CMAKE_INSTALL_LIBDIR}/af2 COMPONENT program)
endfunction()
