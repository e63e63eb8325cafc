// The viewer in doubles: the default view of a scene, and the camera record of a view.
#pragma once

#include "assetc/scene_description.hpp"
#include "core/scene/format.hpp"

namespace spanline::host {

// Why nothing can be seen from `eye` towards `target`, or null.
const char* view_fault(Vec3 eye, Vec3 target, Vec3 up);

// The numbers of a camera that move: eye, target, up, fov.
Pose camera_pose(const CameraSpec& camera);

// A view of the world, all in the scene's own units.
struct View {
  Vec3 eye, target, up;
  double fov;        // degrees, vertical
  double near, far;  // 0 < near < far
};

// The view of `camera` in `frame`. What the description leaves out comes from the bounding sphere of the scene: it fits
// 90 % of the height, seen from (1, 0.8, 1.6); near and far enclose it. `height`: of the picture, px. Throws InputError
// (naming `place`) where the eye is at the target, `up` lies along the view, or the angle is narrower than the engine's
// focal length allows.
View view_in_frame(const CameraSpec& camera, const Sphere& bounds, std::uint16_t height, std::int64_t frame,
                   const std::string& place);

struct Axes {
  Vec3 right, up, back;  // orthonormal
};
Axes axes_of(const View& view);

// The direction of the default light: over the viewer's left shoulder.
Vec3 default_light(const Axes& axes);

// How the scene's own units become world units of the engine: engine = scale * (own - centre).
struct WorldFit {
  double scale = 1;
  Vec3 centre;
  Vec3 operator()(Vec3 p) const { return scale * (p - centre); }
};

// The record of a view on a screen of `height` lines. near and far are cut off to what Q16.16 holds.
CameraRecord camera_record(const View& view, const WorldFit& fit, std::uint16_t height);

}  // namespace spanline::host
