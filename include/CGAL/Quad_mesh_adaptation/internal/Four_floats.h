// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOUR_FLOATS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOUR_FLOATS_H

#if defined(__SSE__) || defined(_M_X64)
#include <xmmintrin.h>
#define CGAL_QUAD_MESH_ADAPTATION_HAS_SSE
#endif

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// Four numbers at a time: compilers do not find that by themselves, for std::max() on references
// looks like a branch to them.  Both versions give the same.
class Four_floats
{
public:
#ifdef CGAL_QUAD_MESH_ADAPTATION_HAS_SSE
  explicit Four_floats(float x) : x_(_mm_set1_ps(x)) {}
  explicit Four_floats(const float* x) : x_(_mm_loadu_ps(x)) {}
  void store(float* x) const { _mm_storeu_ps(x, x_); }

  friend Four_floats operator+(Four_floats a, Four_floats b) { return _mm_add_ps(a.x_, b.x_); }
  friend Four_floats operator-(Four_floats a, Four_floats b) { return _mm_sub_ps(a.x_, b.x_); }
  friend Four_floats operator*(Four_floats a, Four_floats b) { return _mm_mul_ps(a.x_, b.x_); }
  friend Four_floats larger(Four_floats a, Four_floats b) { return _mm_max_ps(a.x_, b.x_); }
  friend Four_floats smaller(Four_floats a, Four_floats b) { return _mm_min_ps(a.x_, b.x_); }
  // Bit i is set where a <= b.
  friend unsigned not_above(Four_floats a, Four_floats b)
  {
    return unsigned(_mm_movemask_ps(_mm_cmple_ps(a.x_, b.x_)));
  }

private:
  Four_floats(__m128 x) : x_(x) {}
  __m128 x_;
#else
  explicit Four_floats(float x) : x_{ x, x, x, x } {}
  explicit Four_floats(const float* x) : x_{ x[0], x[1], x[2], x[3] } {}
  void store(float* x) const
  {
    for(int i = 0; i < 4; ++i) x[i] = x_[i];
  }

  friend Four_floats operator+(Four_floats a, const Four_floats& b)
  {
    for(int i = 0; i < 4; ++i) a.x_[i] += b.x_[i];
    return a;
  }
  friend Four_floats operator-(Four_floats a, const Four_floats& b)
  {
    for(int i = 0; i < 4; ++i) a.x_[i] -= b.x_[i];
    return a;
  }
  friend Four_floats operator*(Four_floats a, const Four_floats& b)
  {
    for(int i = 0; i < 4; ++i) a.x_[i] *= b.x_[i];
    return a;
  }
  friend Four_floats larger(Four_floats a, const Four_floats& b)
  {
    for(int i = 0; i < 4; ++i) a.x_[i] = a.x_[i] > b.x_[i] ? a.x_[i] : b.x_[i];
    return a;
  }
  friend Four_floats smaller(Four_floats a, const Four_floats& b)
  {
    for(int i = 0; i < 4; ++i) a.x_[i] = a.x_[i] < b.x_[i] ? a.x_[i] : b.x_[i];
    return a;
  }
  // Bit i is set where a <= b.
  friend unsigned not_above(const Four_floats& a, const Four_floats& b)
  {
    unsigned bits = 0;
    for(int i = 0; i < 4; ++i) bits |= unsigned(a.x_[i] <= b.x_[i]) << i;
    return bits;
  }

private:
  float x_[4];
#endif
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FOUR_FLOATS_H
