// Copyright (c) 2026 The Quad_mesh_adaptation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PATCH_NUMBERS_H
#define CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PATCH_NUMBERS_H

#include <CGAL/Quad_mesh_adaptation/internal/geometry.h>

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_mesh_adaptation {
namespace internal {

template <typename T, typename = void>
struct has_less : std::false_type
{
};
template <typename T>
struct has_less<T, std::void_t<decltype(std::declval<const T&>() < std::declval<const T&>())>>
    : std::true_type
{
};

// Numbers the caller's patches in the order in which they first appear.  There may be as many as
// faces: values with an order are looked up in a map; those that can only be told apart, in a list.
template <typename Patch>
class Patch_numbers
{
public:
  // The caller's patch behind each number.
  const std::vector<Patch>& patches() const { return patches_; }

  Index number(const Patch& p)
  {
    // neighbours in the iteration over the faces mostly have the same patch
    if(!patches_.empty() && patches_[last_] == p) return last_;
    last_ = look_up(p);
    if(last_ == Index(patches_.size())) patches_.push_back(p);
    return last_;
  }

private:
  struct Nothing
  {
  };

  Index look_up(const Patch& p)
  {
    const Index next = Index(patches_.size());
    if constexpr(has_less<Patch>::value)
      return numbers_.emplace(p, next).first->second;
    else
      return Index(std::find(patches_.begin(), patches_.end(), p) - patches_.begin());
  }

  std::vector<Patch> patches_;
  std::conditional_t<has_less<Patch>::value, std::map<Patch, Index>, Nothing> numbers_;
  Index last_ = 0;
};

} // namespace internal
} // namespace Quad_mesh_adaptation
} // namespace CGAL

#endif // CGAL_QUAD_MESH_ADAPTATION_INTERNAL_PATCH_NUMBERS_H
