// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The core, compiled once for all programs (see compiled_core.h).

#include <CGAL/Quad_mesh_adaptation/internal/Core_run_impl.h>
#include <CGAL/Quad_mesh_adaptation/internal/core_calls_impl.h>
