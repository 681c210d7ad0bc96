# What cpack makes: Debian packages, one for each component of the install. docs/building.md says how.
#
#   program      af2            the program with its rules, manual pages and completion
#   library      libaf2-0.1     the shared library; its version is part of the name, as Debian wants it
#   development  libaf2-dev     headers, CMake package, af2.pc
#   python       python3-af2    the module af2, if it is built
#   formats      af2-formats    writers of files that need libraries of their own (MED, Exodus, CGNS), if they are built
#   mpi          af2-mpi        the program for many machines, if it is built
set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(program_package af2)
set(library_package libaf2-${soversion})
set(development_package libaf2-dev)
set(python_package python3-af2)
set(mpi_package af2-mpi)
set(formats_package af2-formats)
set(program_text "Surface mesher: the program
 It meshes the faces of CAD models, planar domains and surfaces of triangles with triangles and
 quadrilaterals. Rules decide which elements the advancing front adds; they are text files.")
set(library_text "Surface mesher: the shared library
 The engine, the rule language and the readers of models, for programs that mesh surfaces.")
set(development_text "Surface mesher: headers for programs
 Headers, and what find_package(af2) of CMake and pkg-config need.")
set(mpi_text "Surface mesher: the program for many machines
 Meshes the faces of a model on several machines at once, with Open MPI.")
set(formats_text "Surface mesher: more files of meshes
 Writers of MED, Exodus II and CGNS, which the program loads when it is asked for such a file.")
set(python_text "Surface mesher: the Python module
 Models and rules in, meshes as NumPy arrays out.")

set(mpi_DEPENDS program)  # for the rules and the readers
set(formats_DEPENDS program)

# The libraries that static ones are linked with: those of packages.txt that building needs.
if(BUILD_SHARED_LIBS)
  set(development_DEPENDS library program)
else()
  file(STRINGS packages.txt lines)
  foreach(line ${lines})
    if(line STREQUAL "[check]")
      break()
    elseif(line MATCHES "^(lib|zlib).*-dev$")
      list(APPEND development_needs ${line})
    endif()
  endforeach()
  list(JOIN development_needs ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
  set(development_DEPENDS program)
endif()

get_cmake_property(components COMPONENTS)
set(CPACK_COMPONENTS_ALL "")
foreach(component program library development python formats mpi)
  if(NOT component IN_LIST components)
    continue()
  endif()
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${${component}_package})
  set(CPACK_COMPONENT_${upper}_DESCRIPTION ${${component}_text})
  set(CPACK_COMPONENT_${upper}_DEPENDS ${${component}_DEPENDS})
  # Every package has its copyright and its changes; an install without packages has no use for them.
  foreach(file NOTICE=copyright docs/changelog.md=changelog)
    string(REGEX MATCH "(.+)=(.+)" _ ${file})
    install(FILES ${CMAKE_MATCH_1} RENAME ${CMAKE_MATCH_2} COMPONENT ${component} EXCLUDE_FROM_ALL
      DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${${component}_package})
  endforeach()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME af2)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "AF2 <maintainers@users.noreply.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if(formats IN_LIST CPACK_COMPONENTS_ALL)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS af2-formats)
endif()
set(CPACK_DEBIAN_LIBRARY_PACKAGE_PROVIDES "libaf2 (= ${PROJECT_VERSION}-1)")
# Dependencies are those of the libraries that the files are linked with (dpkg-shlibdeps), and Cairo, which is loaded
# for pictures.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS libcairo2)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS libcairo2)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy, libcairo2")
# Copies of OpenCASCADE's libraries that load faster (geometry/occ/binding/binding.cmake) are made on the machine where
# the package is installed, and made again when dpkg has replaced a library.
if(AF2_BUILD_OCC AND AF2_BUILD_CLI AND AF2_BIND_LIBRARIES)
  find_package(OpenCASCADE REQUIRED)
  get_target_property(libraries af2_bind_libraries AF2_LIBRARIES)
  set(own_libraries /usr/${CMAKE_INSTALL_LIBDIR}/af2)
  set(scripts ${PROJECT_BINARY_DIR}/package-scripts)
  set(executable FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  file(GENERATE OUTPUT ${scripts}/postinst CONTENT "#!/bin/sh
set -e
case \"$1\" in configure | triggered)
  # Without the copies the program uses the libraries of the system.
  ${own_libraries}/bind-libraries ${own_libraries}/occ $<JOIN:${libraries}, > || true
esac
" ${executable})
  file(GENERATE OUTPUT ${scripts}/prerm CONTENT "#!/bin/sh
set -e
if [ \"$1\" = remove ]; then rm -rf ${own_libraries}/occ; fi
" ${executable})
  file(GENERATE OUTPUT ${scripts}/triggers CONTENT "interest-noawait $<JOIN:${libraries},\ninterest-noawait >\n")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA ${scripts}/postinst ${scripts}/prerm ${scripts}/triggers)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_STRICT_PERMISSION ON)
endif()
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
include(CPack)
