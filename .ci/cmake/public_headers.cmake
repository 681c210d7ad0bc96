# af2_public_headers(TARGET COMPONENT FILE...): the headers that programs may use. They include them as
# <af2/COMPONENT/NAME.h>, whatever folder of the sources they lie in:
#
# * in the build tree as headers that include the ones of the sources;
# * in an install as copies that include each other in this way. A public header that includes one that is
#   not public stops the installation.
function(af2_public_headers target component)
  set(root ${PROJECT_BINARY_DIR}/include/af2/${component})
  foreach(header ${ARGN})
    cmake_path(GET header FILENAME name)
    set(path ${CMAKE_CURRENT_SOURCE_DIR}/${header})
    if(NOT EXISTS ${path})
      message(FATAL_ERROR "public header ${path} does not exist")
    endif()
    cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE inside)
    file(CONFIGURE OUTPUT ${root}/${name} CONTENT "#include \"${inside}\"\n" @ONLY)
    set_property(GLOBAL APPEND PROPERTY AF2_PUBLIC_HEADERS "${inside}=af2/${component}/${name}")
  endforeach()
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()

# To be called once, after all targets.
function(af2_install_public_headers)
  get_property(headers GLOBAL PROPERTY AF2_PUBLIC_HEADERS)
  list(JOIN headers "\n" lines)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/public_headers.txt CONTENT "${lines}\n" @ONLY)
  install(CODE "
    set(AF2_HEADERS \"${PROJECT_BINARY_DIR}/public_headers.txt\")
    set(AF2_SOURCES \"${PROJECT_SOURCE_DIR}\")
    set(AF2_INCLUDES \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")
    include(\"${PROJECT_SOURCE_DIR}/.ci/cmake/install_headers.cmake\")" COMPONENT development)
endfunction()
