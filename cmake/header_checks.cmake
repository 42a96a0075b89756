# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The target `header_checks` compiles every header alone, twice included: it must bring what it
# uses and guard itself.  `public_header_checks` does so with those that users include.
file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/include/*.h)
find_package(Eigen3 3.3 QUIET NO_MODULE)
if(NOT TARGET Eigen3::Eigen)
  message(STATUS "The headers for curvature are not checked, missing: Eigen")
  list(FILTER headers EXCLUDE REGEX
    "(Curvature_sizing_field|Fold_curvature|Principal_curvatures|chord_sizes|vertex_curvatures)\\.h$")
endif()
set(sources "")
set(public_sources "")
foreach(header IN LISTS headers)
  string(MAKE_C_IDENTIFIER ${header} name)
  set(source ${PROJECT_BINARY_DIR}/header_checks/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include <@header@>\n#include <@header@>\n" @ONLY)
  if(header MATCHES "/internal/")
    list(APPEND sources ${source})
  else()
    list(APPEND public_sources ${source})
  endif()
endforeach()
add_library(public_header_checks OBJECT ${public_sources})
add_library(header_checks OBJECT ${sources})
add_dependencies(header_checks public_header_checks)
foreach(target public_header_checks header_checks)
  target_link_libraries(${target} PRIVATE CGAL::Quad_mesh_adaptation quad_mesh_build_flags
    $<TARGET_NAME_IF_EXISTS:Eigen3::Eigen>)
  # Only the compiler's front end is of interest.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-O0 -g0>)
endforeach()
