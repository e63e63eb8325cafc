#include "core/curve/curve_reader.hpp"

#include "core/base/check.hpp"

namespace spanline {
namespace {

// De Casteljau's points at 1/2 in one coordinate, each rounded from the exact sum: the same from either end.
void split_coordinate(ClipPoint (&left)[4], ClipPoint (&right)[4], std::int32_t ClipPoint::*c) {
  const std::int64_t p0 = left[0].*c, p1 = left[1].*c, p2 = left[2].*c, p3 = left[3].*c;
  const auto put = [c](ClipPoint& point, std::int64_t sum, int shift) {
    point.*c = static_cast<std::int32_t>(shift_round(sum, shift));
  };
  put(left[1], p0 + p1, 1);
  put(left[2], p0 + 2 * p1 + p2, 2);
  put(left[3], p0 + 3 * (p1 + p2) + p3, 3);
  right[0].*c = left[3].*c;
  put(right[1], p1 + 2 * p2 + p3, 2);
  put(right[2], p2 + p3, 1);
  right[3].*c = static_cast<std::int32_t>(p3);
}

struct Range {
  std::int32_t low = INT32_MAX, high = INT32_MIN;
  void add(std::int32_t v) {
    if (v < low) low = v;
    if (v > high) high = v;
  }
  std::int32_t length() const { return high - low; }
};

}  // namespace

ClipCubic ClipCubic::split() {
  ClipCubic right;
  split_coordinate(p, right.p, &ClipPoint::x);
  split_coordinate(p, right.p, &ClipPoint::y);
  split_coordinate(p, right.p, &ClipPoint::w);
  return right;
}

bool ProjectedPieces::nearly_flat_in_w(const ClipCubic& cubic, const Cubic& projected) const {
  Range w, x, y;
  for (int i = 0; i < 4; ++i) {
    w.add(cubic.p[i].w);
    x.add(projected.p[i].x);
    y.add(projected.p[i].y);
  }
  const std::int64_t extent = x.length() > y.length() ? x.length() : y.length();
  return extent * w.length() <= std::int64_t{kSubpixels} * w.low;
}

bool ProjectedPieces::next(Cubic& out) {
  while (count_ != 0) {
    Part& part = stack_[count_ - 1];
    unsigned any = 0, all = 0xff;
    for (const ClipPoint& p : part.cubic.p) {
      any |= projection_.outcode(p);
      all &= projection_.outcode(p);
    }
    const bool last = part.cuts == kMostCuts;
    if (all != 0 || (any != 0 && last)) {
      --count_;
      continue;
    }
    if (any == 0) {
      for (int i = 0; i < 4; ++i) {
        const ScreenXY at = projection_(part.cubic.p[i]).at;
        out.p[i] = {at.x, at.y};
      }
      if (last || nearly_flat_in_w(part.cubic, out)) {
        --count_;
        return true;
      }
    }
    // The second half takes the place of the whole, so that the first one comes first.
    Part first{part.cubic, static_cast<std::uint8_t>(part.cuts + 1)};
    part = {first.cubic.split(), first.cuts};
    stack_[count_++] = first;
  }
  return false;
}

CurveReader::CurveReader(const SceneView& scene, const CameraRecord& camera, const Screen& screen)
    : scene_(&scene.scene()), camera_(&camera), projection_(camera, screen) {
  if (!scene_->instances.empty()) enter_instance(0, 0);
}

void CurveReader::enter_instance(std::uint16_t instance, std::uint16_t first_curve) {
  instance_ = instance;
  first_curve_ = first_curve;
  if (!on_screen() && !mesh().curves.empty()) matrix_ = compose(*camera_, this->instance().transform, mesh());
}

void CurveReader::select(std::uint16_t curve) {
  if (curve < first_curve_) enter_instance(0, 0);
  while (curve - first_curve_ >= static_cast<std::int32_t>(mesh().curves.size())) {
    const auto next = static_cast<std::uint16_t>(first_curve_ + mesh().curves.size());
    enter_instance(static_cast<std::uint16_t>(instance_ + 1), next);
  }
  curve_ = static_cast<std::uint16_t>(curve - first_curve_);
}

Rgb8 CurveReader::color() const {
  const std::uint16_t own = instance().material;
  return scene_->materials[own == InstanceRecord::kOwnMaterials ? record().material : own].color;
}

SpacePoint CurveReader::point(std::uint32_t index) const {
  if (index >= record().point_count) index -= record().point_count;  // a closed curve's
  const Position& p = mesh().positions[mesh().corners[record().first_corner + index]];
  return {p.x, p.y, p.z};
}

CubicOf<SpacePoint> CurveReader::converted(std::uint32_t piece) const {
  CHECK(piece < record().pieces());
  switch (record().kind) {
    case CurveRecord::kBezier:
      return {{point(3 * piece), point(3 * piece + 1), point(3 * piece + 2), point(3 * piece + 3)}};
    case CurveRecord::kQuadratic:
      return from_quadratic(point(2 * piece), point(2 * piece + 1), point(2 * piece + 2));
    case CurveRecord::kBSpline:
      return from_b_spline(point(piece), point(piece + 1), point(piece + 2), point(piece + 3));
    default:
      return from_catmull_rom(point(piece), point(piece + 1), point(piece + 2), point(piece + 3));
  }
}

ClipCubic CurveReader::projected(const CubicOf<SpacePoint>& cubic) const {
  ClipCubic out;
  for (int i = 0; i < 4; ++i) out.p[i] = matrix_(cubic.p[i]);
  return out;
}

Cubic CurveReader::flat(const CubicOf<SpacePoint>& cubic) {
  Cubic out;
  for (int i = 0; i < 4; ++i) out.p[i] = {cubic.p[i].x, cubic.p[i].y};
  return out;
}

}  // namespace spanline
