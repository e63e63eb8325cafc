// The curves of a scene as cubic Bezier curves on the screen, read from the records in place.
#pragma once

#include <cstdint>

#include "core/curve/cubic.hpp"
#include "core/geom/projection.hpp"
#include "core/scene/scene_view.hpp"

namespace spanline {

// A piece of a curve in clip space.
struct ClipCubic {
  ClipPoint p[4];

  // Leaves its first half here, returns the second. Both ends round the same way.
  ClipCubic split();
};

// Cuts a piece until what is left may be walked as if it were no rational curve, and hands that to the caller, in
// order.
//
// Projecting control points instead of the curve is off by at most a quarter of extent * (w_max / w_min - 1), so pieces
// are halved until that extent is a pixel. What lies outside a plane of the view is dropped; where a curve crosses one,
// halving ends at 1 / 2^kMostCuts of it, and that bit is dropped too.
class ProjectedPieces {
 public:
  ProjectedPieces(const Projection& projection, const ClipCubic& whole) : projection_(projection) {
    stack_[0] = {whole, 0};
  }

  // The next piece; false after the last.
  bool next(Cubic& out);

 private:
  static constexpr unsigned kMostCuts = 8;
  struct Part {
    ClipCubic cubic;
    std::uint8_t cuts;
  };
  bool nearly_flat_in_w(const ClipCubic& cubic, const Cubic& projected) const;

  const Projection& projection_;
  Part stack_[kMostCuts + 1];
  unsigned count_ = 1;
};

// Reads curves by number. Keeps the matrix of the instance that was read last, so reading in order is cheap.
class CurveReader {
 public:
  CurveReader() = default;
  CurveReader(const SceneView& scene, const CameraRecord& camera, const Screen& screen);

  // Makes `curve` (below SceneView::curve_count) current.
  void select(std::uint16_t curve);
  const CurveRecord& record() const { return mesh().curves[curve_]; }
  bool hidden() const { return (instance().flags & InstanceRecord::kHidden) != 0; }
  Rgb8 color() const;

  // Hands a piece of the current curve (below CurveRecord::pieces) to sink(const Cubic&), in one part or several.
  template <typename Sink>
  void read(std::uint32_t piece, Sink&& sink) const {
    const CubicOf<SpacePoint> cubic = converted(piece);
    if (on_screen()) return sink(flat(cubic));
    ProjectedPieces parts(projection_, projected(cubic));
    for (Cubic part; parts.next(part);) sink(part);
  }

 private:
  const InstanceRecord& instance() const { return scene_->instances[instance_]; }
  const MeshRecord& mesh() const { return scene_->meshes[instance().mesh]; }
  bool on_screen() const { return (instance().flags & InstanceRecord::kScreen) != 0; }
  void enter_instance(std::uint16_t instance, std::uint16_t first_curve);
  SpacePoint point(std::uint32_t index) const;
  CubicOf<SpacePoint> converted(std::uint32_t piece) const;
  ClipCubic projected(const CubicOf<SpacePoint>& cubic) const;
  static Cubic flat(const CubicOf<SpacePoint>& cubic);

  const SceneRecord* scene_ = nullptr;
  const CameraRecord* camera_ = nullptr;
  Projection projection_{CameraRecord{}, Screen{}};
  ClipMatrix matrix_{};
  std::uint16_t instance_ = 0;
  std::uint16_t first_curve_ = 0;  // of the instance, over the scene
  std::uint16_t curve_ = 0;        // of the mesh
};

}  // namespace spanline
