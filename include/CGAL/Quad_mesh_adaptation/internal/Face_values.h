// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_VALUES_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_VALUES_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

// A number that several threads may read and write, as long as they write the same.
template <typename Number>
class Shared_number
{
public:
  Shared_number(Number x) : x_(x) {}
  Shared_number(const Shared_number& other) : x_(Number(other)) {}
  Shared_number& operator=(const Shared_number& other) { return *this = Number(other); }
  Shared_number& operator=(Number x)
  {
    x_.store(x, std::memory_order_relaxed);
    return *this;
  }
  operator Number() const { return x_.load(std::memory_order_relaxed); }

private:
  std::atomic<Number> x_;
};

// A value for each face that was worked out since the face changed last.  Threads may ask at the
// same time after fit().
template <typename Number>
class Face_values
{
public:
  bool is_known(Index f) const { return f < Index(values_.size()) && !std::isnan((*this)[f]); }
  // Precondition: it is known.
  Number operator[](Index f) const { return values_[f]; }

  // `face_end`: number of records in the mesh.  Returns the value.
  Number set(Index f, Number value, Index face_end)
  {
    if(f >= Index(values_.size())) fit(face_end);
    values_[f] = value;
    return value;
  }
  void fit(Index face_end)
  {
    const std::size_t n = std::size_t(face_end);
    if(n > values_.capacity()) values_.reserve(n + n / 8); // twice as much would be much
    if(n > values_.size()) values_.resize(n, unknown);
  }
  void forget(Index f)
  {
    if(f < Index(values_.size())) values_[f] = unknown;
  }
  void forget_all() { values_.clear(); }

private:
  static constexpr Number unknown = std::numeric_limits<Number>::quiet_NaN();
  std::vector<Shared_number<Number>> values_;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_FACE_VALUES_H
