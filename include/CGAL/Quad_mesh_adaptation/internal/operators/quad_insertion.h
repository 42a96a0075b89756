// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUAD_INSERTION_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUAD_INSERTION_H

#include <CGAL/Quad_mesh_adaptation/internal/Cavity.h>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Quad insertion (1 to 5): an inner quad, joined to the four corners of face f.  F + 4, V + 4; the
// corners gain an edge each, the new nodes have three.  It gives a border node with one flat face a
// second one, where nothing cheaper does.
inline bool is_quad_insertion_allowed(const Adaptation_state& s, Index f)
{
  return s.mesh.is_face(f);
}

inline void describe_quad_insertion(Adaptation_state& s, Index f, Cavity& cavity)
{
  const Quad_complex& m = s.mesh;
  const Quad q = m.quad(f);
  cavity.clear();
  cavity.add_old_face(f);
  const Corners p = s.corners(f);
  const Vec centre = face_centre(p);
  int outer[4], inner[4];
  for(int i = 0; i < 4; ++i) {
    outer[i] = cavity.node(q[i]);
    Vertex_record r = m.vertex(q[i]);
    r.carrier = Carrier::surface;
    r.curve = -1;
    r.frozen = false;
    r.ideal_faces = 4;
    r.p = 0.5 * (p[i] + centre);
    r.hint = s.triangle_near(f, r.p);
    s.place(r);
    inner[i] = cavity.add_new_node(r);
  }
  cavity.add_quad(inner[0], inner[1], inner[2], inner[3], { -1, -1, -1, -1 }, f);
  for(int i = 0; i < 4; ++i) {
    const int j = (i + 1) & 3;
    cavity.add_quad(outer[i], outer[j], inner[j], inner[i], { m.curve(4 * f + i), -1, -1, -1 }, f);
  }
}

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_QUAD_INSERTION_H
