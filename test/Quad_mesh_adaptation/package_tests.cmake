# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Tests of the package as a whole: it installs and is found from a separate project, and the C++
# example of the README is the one that is compiled.

set(install_dir ${CMAKE_CURRENT_BINARY_DIR}/installed)
add_test(NAME package.install
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${install_dir})
set_tests_properties(package.install PROPERTIES FIXTURES_SETUP installed_package)

# CGAL_DIR is passed so that the consumer sees the CGAL of this build.  Not optimized: that would
# take minutes for a program of a moment.
add_test(NAME package.find_package
  COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${CMAKE_CURRENT_BINARY_DIR}/consumer
    --build-generator ${CMAKE_GENERATOR} --build-noclean
    --build-options -DCMAKE_PREFIX_PATH=${install_dir} -DCGAL_DIR=${CGAL_DIR}
      -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_CXX_FLAGS_RELEASE=-DNDEBUG
      -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
    --test-command consumer)
set_tests_properties(package.find_package PROPERTIES FIXTURES_REQUIRED installed_package
  TIMEOUT 600 COST 100)

# The text between the first "```cpp" and the next "```" of the README.
set(readme ${PROJECT_SOURCE_DIR}/README.md)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${readme})
file(READ ${readme} text)
string(FIND "${text}" "```cpp\n" begin)
if(begin EQUAL -1)
  message(FATAL_ERROR "README.md holds no C++ example")
endif()
math(EXPR begin "${begin} + 7")
string(SUBSTRING "${text}" ${begin} -1 text)
string(FIND "${text}" "```" end)
string(SUBSTRING "${text}" 0 ${end} text)
file(CONFIGURE OUTPUT readme_example.cpp CONTENT "@text@" @ONLY)
add_executable(readme_example ${CMAKE_CURRENT_BINARY_DIR}/readme_example.cpp)
quad_mesh_link(readme_example)
add_test(NAME package.readme_example
  COMMAND readme_example ${CMAKE_CURRENT_SOURCE_DIR}/data/readme_input.off
    ${CMAKE_CURRENT_BINARY_DIR}/readme_output.off)
