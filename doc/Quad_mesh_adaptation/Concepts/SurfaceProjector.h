// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgQuadMeshAdaptationConcepts
\cgalConcept

The concept `SurfaceProjector` describes the surface that the nodes are to lie on, as a function
given to `projector()`; and, given to `curve_projector()`, the feature curves and borders.

What is asked: for a point of the surface that is known already (the facets of the input, or those
of `reference_surface()`), the point of the true surface that belongs to it.  The nearest point of
an analytic or CAD surface is such a function.

Requirements on the function, which no compiler can check:

- It is defined for each point of the facets (a `curve_projector()`: of the polylines of the
  feature curves and borders), up to rounding.  It is not called with other points.
- Its coordinates are finite.  A value that is not ends the call with
  `Adaptation_status::input_refused`, `Refusal::invalid_parameter` and the point in the message.
- It is continuous along the facets of a patch, and one-to-one where the mesh is to be one-to-one.
  Over a step of an edge it moves points by less than that edge.
- The same point gets the same value, however often and in whatever order it is asked: the result
  is repeatable only then.
- It may throw.  The exception reaches the caller of `adapt_quad_mesh()`, whose mesh is unchanged.
- A `curve_projector()` gives points of the surface of the `projector()`, if both are used.

Corners are not projected, and curves only by the `curve_projector()`.  A projector cannot be
combined with `smooth_reference()`.  Calls are made from one thread, or from
several with `concurrency(CGAL::Parallel_tag())`; some tens per node that is moved, so a call that
takes a microsecond will dominate the time.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{any function, lambda or function object with one of the two signatures}
\cgalHasModelsEnd

Not models, but built in and asked for by other parameters: the facets of the input (the default),
a finer surface (`reference_surface()`), a smooth surface through the vertices
(`smooth_reference()`).  They find the nearest point within the patch of a node and on the side
that faces the right way, so that neighbouring sheets do not attract each other's nodes.
*/
class SurfaceProjector
{
public:
  /// The type of the mesh's points: the value type of the vertex point map.
  typedef unspecified_type Point_3;

  /// `Point_3`, or `std::pair<Point_3, Vector_3>` with the normal of the surface at that point: of
  /// any length, in either sense.  Where there is none, or zero, the facet's normal is taken.
  typedef unspecified_type result_type;

  /// The point of the true surface that belongs to `p`.
  result_type operator()(const Point_3& p) const;
};
