// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The core, compiled once for all programs (see core_calls.h).

#include <CGAL/Quad_mesh_adaptation/internal/core_calls_impl.h>
