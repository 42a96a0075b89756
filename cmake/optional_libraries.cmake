# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Libraries that single programs need; the package itself needs none of them.
find_package(Eigen3 3.3 QUIET NO_MODULE)
find_package(CLI11 QUIET)
find_package(nlohmann_json QUIET)
find_package(muparser QUIET)
find_package(benchmark QUIET)
find_package(TBB QUIET)
include(CGAL_TBB_support)

set(library_of_Eigen Eigen3::Eigen)
set(library_of_CLI11 CLI11::CLI11)
set(library_of_json nlohmann_json::nlohmann_json)
set(library_of_muParser muparser::muparser)
set(library_of_GoogleBenchmark benchmark::benchmark)
set(library_of_TBB CGAL::TBB_support)
set(library_of_options quad_mesh_example_options)

# The core, compiled once for all programs of this project, which saves most of their compile time.
# The package is header-only all the same: the checks of the headers, the test of the installed
# package and whoever does not define this macro compile it so.
add_library(quad_mesh_core STATIC EXCLUDE_FROM_ALL
  ${PROJECT_SOURCE_DIR}/examples/Quad_mesh_adaptation/support/compiled_core.cpp
  ${PROJECT_SOURCE_DIR}/examples/Quad_mesh_adaptation/support/compiled_files.cpp)
target_link_libraries(quad_mesh_core PUBLIC CGAL::Quad_mesh_adaptation
  PRIVATE quad_mesh_build_flags)
target_compile_definitions(quad_mesh_core PUBLIC QUAD_MESH_ADAPTATION_COMPILED_CORE)
# With threads where TBB is there: then for all programs, for they share the compiled core.
target_link_libraries(quad_mesh_core PUBLIC $<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>)

# Links `target` to the libraries that are named (Eigen, CLI11, json, muParser, GoogleBenchmark, TBB,
# options: those of the programs of the paper's cases).
function(quad_mesh_link target)
  target_link_libraries(${target} PRIVATE quad_mesh_core quad_mesh_build_flags)
  foreach(name IN LISTS ARGN)
    target_link_libraries(${target} PRIVATE ${library_of_${name}})
  endforeach()
endfunction()

# The compiled core does most of the work and is optimized as ever.  For the sources of tests and of
# examples that costs more time than it saves when they run.
set(default_test_options "")
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(default_test_options -O1)
endif()
set(QUAD_MESH_ADAPTATION_TEST_OPTIONS "${default_test_options}" CACHE STRING
  "Further options of the compiler for the sources of tests and of examples")

# Links the whole compiled core before the objects of `target`: of inline functions that both have,
# the linker keeps the first, here those of the core, which may be compiled with other options.
function(quad_mesh_core_first target)
  if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    target_link_options(${target} PRIVATE
      LINKER:--whole-archive $<TARGET_FILE:quad_mesh_core> LINKER:--no-whole-archive)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS $<TARGET_FILE:quad_mesh_core>)
  endif()
endfunction()

# Sets `result` to ON when all named libraries are there; if not, says what `target` lacks.
function(quad_mesh_check_libraries result target)
  set(missing "")
  foreach(name IN LISTS ARGN)
    if(NOT DEFINED library_of_${name})
      message(FATAL_ERROR "${target}: unknown library '${name}'")
    elseif(NOT TARGET ${library_of_${name}})
      list(APPEND missing ${name})
    endif()
  endforeach()
  if(missing)
    list(JOIN missing ", " missing)
    message(STATUS "${target} is not built, missing: ${missing}")
    set(${result} OFF PARENT_SCOPE)
  else()
    set(${result} ON PARENT_SCOPE)
  endif()
endfunction()

# quad_mesh_program(name [INSTALL] [LIBRARIES Eigen CLI11 json muParser GoogleBenchmark options]
#                   [SOURCES file.cpp ...])
# builds the sources, by default name.cpp.
function(quad_mesh_program name)
  cmake_parse_arguments(program "INSTALL" "" "LIBRARIES;SOURCES" ${ARGN})
  quad_mesh_check_libraries(is_complete ${name} ${program_LIBRARIES})
  if(NOT is_complete)
    return()
  endif()
  if(NOT program_SOURCES)
    set(program_SOURCES ${name}.cpp)
  endif()
  add_executable(${name} ${program_SOURCES})
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  quad_mesh_link(${name} ${program_LIBRARIES})
  # for CGAL::data_file_path()
  target_compile_definitions(${name} PRIVATE CGAL_DATA_DIR="${PROJECT_SOURCE_DIR}/data")
  if(program_INSTALL)
    install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs OPTIONAL)
  endif()
endfunction()
