// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COMPILED_CORE_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COMPILED_CORE_H

// The calls from the templates over the caller's mesh down into what knows no such template.  They
// are inline, and the package header-only, unless QUAD_MESH_ADAPTATION_COMPILED_CORE is defined:
// then source files that include the headers named ..._impl.h compile this for all others, which
// takes most of their compile time away.  The programs of this project are built so.
#ifdef QUAD_MESH_ADAPTATION_COMPILED_CORE
#define CGAL_QUAD_MESH_ADAPTATION_CORE_CALL
#else
#define CGAL_QUAD_MESH_ADAPTATION_CORE_CALL inline
#endif

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_COMPILED_CORE_H
