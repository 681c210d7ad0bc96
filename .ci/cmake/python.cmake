# Adds the Python package if there is what it needs: pybind11, and a Python with headers and NumPy. Of several Pythons, the
# one of the system is taken, because the headers of Debian's packages are its; -DPython3_EXECUTABLE names another one.
set(PYBIND11_NOPYTHON ON)  # CMake finds Python, and pybind11 is only headers
find_package(pybind11 QUIET CONFIG)
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 3.9 QUIET COMPONENTS Interpreter Development.Module)
set(has_numpy 1)
if(Python3_Interpreter_FOUND)
  execute_process(COMMAND ${Python3_EXECUTABLE} -c "import numpy" RESULT_VARIABLE has_numpy ERROR_QUIET)
endif()
if(pybind11_FOUND AND Python3_Development.Module_FOUND AND has_numpy EQUAL 0)
  add_subdirectory(python)
else()
  message(STATUS "The Python package is not built: it needs pybind11, the headers of Python and NumPy")
endif()
