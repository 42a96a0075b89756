// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reading and writing of files, compiled once for all programs (see compiled_core.h).

#include <CGAL/Quad_mesh_adaptation/internal/File_transaction_impl.h>
#include <CGAL/Quad_mesh_adaptation/internal/Picture_impl.h>
#include <CGAL/Quad_mesh_adaptation/internal/file_calls_impl.h>
