// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#define QUAD_MESH_TEST_INSTANCE template
#include "usual_files.h"
#include "usual_measures.h"
#include "usual_mesh.h"
