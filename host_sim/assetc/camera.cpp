#include "assetc/camera.hpp"

#include "assetc/fixed_point.hpp"
#include "assetc/input_error.hpp"
#include "core/geom/camera.hpp"

namespace spanline::host {
namespace {

constexpr double kFill = 0.9;          // of the height, by the bounding sphere
constexpr double kRoomAround = 1.02;   // near and far stand this much off the bounding sphere
constexpr double kNearestPart = 0.01;  // near, as a part of the radius, when the eye is inside the sphere

// A sphere of radius r at distance d covers r / sqrt(d^2 - r^2) on the picture plane at 1.
double fitting_distance(double radius, double fov) {
  const double half_height = kFill * std::tan(radians(fov) / 2);
  return radius * std::sqrt(1 + 1 / (half_height * half_height));
}

// Rounded up to a tenth of a degree.
std::string narrowest_fov(std::uint16_t height) {
  const double fov = 2 * std::atan(height / 2.0 / kMaxFocalPx) * 180 / std::numbers::pi;
  std::string text = std::to_string(std::ceil(fov * 10) / 10);
  return text.substr(0, text.find('.') + 2);
}

}  // namespace

const char* view_fault(Vec3 eye, Vec3 target, Vec3 up) {
  if (eye == target) return "the camera's eye is at its target";
  if (largest(up) == 0) return "the camera's up vector is zero";
  const Vec3 forward = unit_or(target - eye, {});
  if (length(cross(forward, unit_or(up, {}))) < 1e-9) return "the camera's up vector lies along its view";
  return nullptr;
}

Pose camera_pose(const CameraSpec& camera) {
  return {camera.eye.x,    camera.eye.y, camera.eye.z, camera.target.x, camera.target.y,
          camera.target.z, camera.up.x,  camera.up.y,  camera.up.z,     camera.fov};
}

View view_in_frame(const CameraSpec& camera, const Sphere& bounds, std::uint16_t height, std::int64_t frame,
                   const std::string& place) {
  const double radius = bounds.radius > 0 ? bounds.radius : 1;
  CameraSpec rest = camera;
  if (!rest.has_target) rest.target = bounds.centre;
  if (!rest.has_eye) {
    rest.eye = rest.target + fitting_distance(radius, rest.fov) * unit_or({1, 0.8, 1.6}, {});
  }
  const Pose p = camera.motion.at(frame, camera_pose(rest));
  View view{{p[0], p[1], p[2]}, {p[3], p[4], p[5]}, {p[6], p[7], p[8]}, p[9], 0, 0};
  if (const char* fault = view_fault(view.eye, view.target, view.up)) {
    throw InputError(place, std::string(fault) + (frame > 0 ? " in frame " + std::to_string(frame) : ""));
  }
  if (height / 2.0 / std::tan(radians(view.fov) / 2) > kMaxFocalPx) {
    throw InputError(place, "the camera's angle of view is too narrow: at this height it must be above " +
                                narrowest_fov(height) + " degrees");
  }
  const double distance = length(view.eye - bounds.centre);
  view.near = camera.near.value_or(std::max(distance - kRoomAround * radius, kNearestPart * radius));
  view.far = camera.far.value_or(std::max(distance + kRoomAround * radius, 2 * view.near));
  if (!camera.near && view.near >= view.far) view.near = kNearestPart * view.far;
  return view;
}

Axes axes_of(const View& view) {
  const Vec3 back = unit_or(view.eye - view.target, {0, 0, 1});
  const Vec3 right = unit_or(cross(unit_or(view.up, {0, 1, 0}), back), {1, 0, 0});
  return {right, cross(back, right), back};
}

Vec3 default_light(const Axes& axes) { return unit_or(0.25 * axes.right - 0.7 * axes.up - axes.back, {0, 0, -1}); }

CameraRecord camera_record(const View& view, const WorldFit& fit, std::uint16_t height) {
  const Axes axes = axes_of(view);
  const Vec3 eye = fit(view.eye);
  CameraRecord record{};
  const Vec3 rows[3] = {axes.right, axes.up, axes.back};
  for (int i = 0; i < 3; ++i) put(record.axes[i], rows[i]);
  put(record.eye, eye);
  record.focal = to_fixed<12>(0.5 * height / std::tan(radians(view.fov) / 2));
  record.focal.raw = std::max(record.focal.raw, 1);
  record.near_plane = to_fixed<16>(fit.scale * view.near);
  record.far_plane = to_fixed<16>(fit.scale * view.far);
  record.near_plane.raw = std::clamp(record.near_plane.raw, 1, INT32_MAX - 1);
  record.far_plane.raw = std::max(record.far_plane.raw, record.near_plane.raw + 1);
  return record;
}

}  // namespace spanline::host
