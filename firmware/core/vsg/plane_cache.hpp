#pragma once

#include <bit>

#include "core/vsg/active_edge.hpp"
#include "core/vsg/depth.hpp"

namespace spanline {

// A depth plane that was needed once: of a face that another one overlaps.
struct CachedPlane {
  DepthPlane plane;
  std::uint32_t face = 0;  // FaceId
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

 private:
  template <typename Make>
  [[gnu::noinline]] static void keep(CachedPlane& entry, FaceId face, const Make& make) {
    entry = {make(face), face};
  }

  PoolRef<CachedPlane> planes_;
  std::uint32_t mask_ = 0;
};

}  // namespace spanline
