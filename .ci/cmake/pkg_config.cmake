# af2_install_pkg_config(TARGET...): writes af2.pc for programs that are built without CMake. The shared library
# needs nothing else; static ones need each other, and what they are made of.
function(af2_install_pkg_config)
  if(BUILD_SHARED_LIBS)
    set(libraries -laf2)
  else()
    set(libraries -Wl,--start-group)
    foreach(target ${ARGN})
      list(APPEND libraries -l${target})
    endforeach()
    list(APPEND libraries -Wl,--end-group -lfmt -ltbb -lz -lmpfr -lgmp)
    foreach(name ${AF2_OCC_LIBRARIES})
      list(APPEND libraries -l${name})
    endforeach()
    list(APPEND libraries -lpthread)
  endif()
  list(JOIN libraries " " libraries)
  set(headers -I\${includedir})
  if(AF2_BUILD_OCC)
    string(APPEND headers " -isystem ${OpenCASCADE_INCLUDE_DIR}")
  endif()
  # Relative to the file itself, so that an install may be moved.
  set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH prefix /${folder} /)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/af2.pc CONTENT [[
prefix=${pcfiledir}/@prefix@
libdir=${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=${prefix}/@CMAKE_INSTALL_INCLUDEDIR@
rulesdir=${prefix}/@AF2_RULES_DIR@

Name: af2
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Cflags: -std=c++20 @headers@
Libs: -L${libdir} @libraries@
]] @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/af2.pc DESTINATION ${folder} COMPONENT development)
endfunction()
