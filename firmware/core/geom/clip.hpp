// Clipping of one contour to the view, a vertex at a time: Sutherland and Hodgman's re-entrant pipeline (1974), so that a
// polygon of any number of sides needs no scratch memory.
#pragma once

#include <cstdint>

#include "core/fx/bits.hpp"
#include "core/geom/projection.hpp"

namespace spanline {

struct ClipVertex {
  ClipPoint at;
  Rgb8 color;
};

// Signed distance inside a plane (Outcode bit), in clip units.
constexpr std::int64_t clip_distance(const ClipPoint& p, std::uint8_t plane, const Projection& projection) {
  switch (plane) {
    case Outcode::kNear:
      return std::int64_t{p.w} - projection.near_w;
    case Outcode::kFar:
      return std::int64_t{projection.far_w} - p.w;
    case Outcode::kLeft:
      return std::int64_t{p.w} + p.x;
    case Outcode::kRight:
      return std::int64_t{p.w} - p.x;
    case Outcode::kTop:
      return std::int64_t{p.w} + p.y;
    default:
      return std::int64_t{p.w} - p.y;
  }
}

// Where the edge from an inside to an outside point meets the plane. Always asked from inside to outside, so both faces of an
// edge get the same vertex. distances: inside >= 0 > outside.
inline ClipVertex clip_edge(const ClipVertex& inside, std::int64_t inside_distance, const ClipVertex& outside,
                            std::int64_t outside_distance) {
  const std::int64_t t = (inside_distance << 30) / (inside_distance - outside_distance);  // Q2.30; distances below 2^33
  const auto mix = [t](std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(a + (((std::int64_t{b} - a) * t) >> 30));
  };
  return {{mix(inside.at.x, outside.at.x), mix(inside.at.y, outside.at.y), mix(inside.at.w, outside.at.w)},
          {static_cast<std::uint8_t>(mix(inside.color.r, outside.color.r)),
           static_cast<std::uint8_t>(mix(inside.color.g, outside.color.g)),
           static_cast<std::uint8_t>(mix(inside.color.b, outside.color.b))}};
}

// Feeds one contour through the planes in `planes`; Sink has vertex(const ClipVertex&). Call vertex() for each corner in order,
// then finish().
template <typename Sink>
class ContourClipper {
 public:
  ContourClipper(const Projection& projection, std::uint8_t planes, Sink& sink)
      : projection_(projection), planes_(planes), sink_(sink) {}

  void vertex(const ClipVertex& v) { push<0>(v); }
  void finish() { close<0>(); }

 private:
  static constexpr int kPlanes = 6;
  struct Stage {
    ClipVertex first, previous;
    std::int64_t first_distance, previous_distance;
    bool any = false;
  };

  template <int kStage>
  void push(const ClipVertex& v) {
    if constexpr (kStage == kPlanes) {
      sink_.vertex(v);
    } else {
      constexpr auto kPlane = static_cast<std::uint8_t>(1 << kStage);
      if ((planes_ & kPlane) == 0) return push<kStage + 1>(v);
      Stage& stage = stages_[kStage];
      const std::int64_t distance = clip_distance(v.at, kPlane, projection_);
      if (stage.any) {
        cross<kStage>(stage, v, distance);
      } else {
        stage.first = v;
        stage.first_distance = distance;
        stage.any = true;
      }
      stage.previous = v;
      stage.previous_distance = distance;
      if (distance >= 0) push<kStage + 1>(v);
    }
  }

  template <int kStage>
  void cross(const Stage& stage, const ClipVertex& v, std::int64_t distance) {
    const bool was_inside = stage.previous_distance >= 0;
    if (was_inside == (distance >= 0)) return;
    push<kStage + 1>(was_inside ? clip_edge(stage.previous, stage.previous_distance, v, distance)
                                : clip_edge(v, distance, stage.previous, stage.previous_distance));
  }

  template <int kStage>
  void close() {
    if constexpr (kStage < kPlanes) {
      Stage& stage = stages_[kStage];
      if (stage.any) cross<kStage>(stage, stage.first, stage.first_distance);
      stage.any = false;
      close<kStage + 1>();
    }
  }

  const Projection& projection_;
  const std::uint8_t planes_;
  Sink& sink_;
  Stage stages_[kPlanes];
};

}  // namespace spanline
