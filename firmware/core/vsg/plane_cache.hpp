#pragma once

#include <bit>

#include "core/vsg/active_edge.hpp"
#include "core/vsg/depth.hpp"

namespace spanline {

// What is known of the depth of a face that another one overlaps: how far it reaches or, where that did not do, its
// plane.
struct CachedPlane {
  CachedPlane() : reach{} {}

  union {
    DepthReach reach;
    DepthPlane plane;
  };
  std::uint32_t face = 0;  // FaceId; and kReach

  static constexpr std::uint32_t kReach = 1u << 16;
};
static_assert(sizeof(CachedPlane) == 16);

// The planes made last, each in the place that its face's number gives it.
class PlaneCache {
 public:
  PlaneCache() = default;
  explicit PlaneCache(PoolRef<CachedPlane> planes)
      : planes_(planes), mask_(std::bit_floor(static_cast<std::uint32_t>(planes.capacity()) + 1u) - 1u) {}

  void clear() {
    for (std::uint32_t i = 0; i <= mask_; ++i) planes_[i].face = 0;
  }

  // The face's plane; make(face) where it is not here. Valid until the next call.
  template <typename Make>
  const DepthPlane& of(FaceId face, const Make& make) {
    CachedPlane& entry = planes_[face & mask_];
    if (entry.face != face) [[unlikely]]
      keep(entry, face, make);
    return entry.plane;
  }
  // Likewise how far it reaches, which make(face, reach) says; nullptr where its plane is here.
  template <typename Make>
  const DepthReach* reach(FaceId face, const Make& make) {
    CachedPlane& entry = planes_[face & mask_];
    const std::uint32_t tag = face | CachedPlane::kReach;
    if (entry.face != tag) [[unlikely]] {
      if (entry.face == face) return nullptr;
      entry.face = tag;
      make(face, entry.reach);
    }
    return &entry.reach;
  }

 private:
  template <typename Make>
  [[gnu::noinline]] static void keep(CachedPlane& entry, FaceId face, const Make& make) {
    entry.plane = make(face);
    entry.face = face;
  }

  PoolRef<CachedPlane> planes_;
  std::uint32_t mask_ = 0;
};

}  // namespace spanline
