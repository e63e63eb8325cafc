#pragma once

#include <bit>

#include "core/vsg/active_edge.hpp"
#include "core/vsg/depth.hpp"

namespace spanline {

// Where a face lies along the view: no corner is nearer or farther. The maker's units.
struct DepthReach {
  FaceId face = 0;
  std::int16_t nearest = 0, farthest = 0;
};

struct CachedPlane {
  DepthPlane plane;
  std::uint32_t face = 0;  // FaceId
};
static_assert(sizeof(CachedPlane) == 16 && sizeof(DepthReach) == 6);

// What is known of the depth of faces that others overlap: how far those met last reach and, of some of them, their
// planes, each in the place that its face's number gives it.
class PlaneCache {
 public:
  // Mostly a face's reach will do.
  static constexpr std::uint32_t kReachesPerPlane = 4;
  static constexpr std::uint16_t reaches_for(std::uint16_t planes) {
    return static_cast<std::uint16_t>((planes + 1u) * kReachesPerPlane - 1);
  }

  PlaneCache() = default;
  constexpr PlaneCache(PoolRef<CachedPlane> planes, PoolRef<DepthReach> reaches)
      : planes_(planes), reaches_(reaches), mask_(mask_of(planes)), reach_mask_(mask_of(reaches)) {}

  void clear() {
    clear_planes();
    for (std::uint32_t i = 0; i <= reach_mask_; ++i) reaches_[i].face = 0;
  }
  void clear_planes() {
    for (std::uint32_t i = 0; i <= mask_; ++i) planes_[i].face = 0;
  }

  // The face's plane; make(face) where it is not here. Valid until the next call.
  template <typename Make>
  const DepthPlane& of(FaceId face, const Make& make) {
    CachedPlane& entry = planes_[place(face) & mask_];
    if (entry.face != face) [[unlikely]]
      keep(entry, face, make);
    return entry.plane;
  }
  // How far it reaches; make(DepthReach&) where that is not here. Likewise.
  template <typename Make>
  const DepthReach& reach(FaceId face, const Make& make) {
    return reach_at(place(face), face, make);
  }
  // The same by another number that gives it its place, of faces that are numbered in another way.
  template <typename Make>
  const DepthReach& reach_at(std::uint32_t place, FaceId face, const Make& make) {
    DepthReach& entry = reaches_[place & reach_mask_];
    if (entry.face != face) [[unlikely]] {
      make(entry);
      entry.face = face;
    }
    return entry;
  }

 private:
  // Faces of strips that run beside each other differ by strips' lengths, which are often even.
  static std::uint32_t place(FaceId face) { return face ^ face >> 3; }
  template <typename T>
  static constexpr std::uint32_t mask_of(const PoolRef<T>& pool) {
    return std::bit_floor(static_cast<std::uint32_t>(pool.capacity()) + 1u) - 1u;
  }
  template <typename Make>
  [[gnu::noinline]] static void keep(CachedPlane& entry, FaceId face, const Make& make) {
    entry.plane = make(face);
    entry.face = face;
  }

  PoolRef<CachedPlane> planes_;
  PoolRef<DepthReach> reaches_;
  std::uint32_t mask_ = 0, reach_mask_ = 0;
};

}  // namespace spanline
