#include "core/geom/clip.hpp"

namespace spanline {

namespace {

// Signed distance inside a plane (Outcode bit), in clip units.
std::int64_t clip_distance(const ClipPoint& p, std::uint8_t plane, const Projection& projection) {
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

// Where the edge from an inside to an outside point meets the plane. Always asked from inside to outside, so both faces
// of an edge get the same vertex. distances: inside >= 0 > outside.
ClipVertex clip_edge(const ClipVertex& inside, std::int64_t inside_distance, const ClipVertex& outside,
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

}  // namespace

bool ContourClipper::next(ClipVertex& out) {
  for (;;) {
    while (count_ != 0) {
      const Work work = work_[--count_];
      if (work.stage == kPlanes) {
        out = work.vertex;
        return true;
      }
      pass(work.stage, work.vertex);
    }
    if (closing_ == kPlanes) return false;
    Stage& stage = stages_[closing_];
    if (stage.any) push_crossing(closing_, stage.first, stage.first_distance);
    stage.any = false;
    ++closing_;
  }
}

// One vertex through one stage: first what the edge to it yields, then the vertex itself; so they are put on the stack
// the other way round.
void ContourClipper::pass(unsigned index, const ClipVertex& v) {
  const auto plane = static_cast<std::uint8_t>(1u << index);
  if ((planes_ & plane) == 0) return push(index + 1, v);
  Stage& stage = stages_[index];
  const std::int64_t distance = clip_distance(v.at, plane, projection_);
  if (distance >= 0) push(index + 1, v);
  if (stage.any) {
    push_crossing(index, v, distance);
  } else {
    stage.first = v;
    stage.first_distance = distance;
    stage.any = true;
  }
  stage.previous = v;
  stage.previous_distance = distance;
}

void ContourClipper::push_crossing(unsigned index, const ClipVertex& v, std::int64_t distance) {
  const Stage& stage = stages_[index];
  const bool was_inside = stage.previous_distance >= 0;
  if (was_inside == (distance >= 0)) return;
  push(index + 1, was_inside ? clip_edge(stage.previous, stage.previous_distance, v, distance)
                             : clip_edge(v, distance, stage.previous, stage.previous_distance));
}

}  // namespace spanline
