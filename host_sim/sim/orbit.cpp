#include "sim/orbit.hpp"

namespace spanline::host {

Orbit::Orbit(const View& view, const Sphere& bounds, std::uint16_t height, double reach)
    : start_(view), bounds_(bounds), height_px_(height), reach_(reach) {
  if (!(bounds_.radius > 0)) bounds_.radius = 1;
  const Vec3 away = view.eye - view.target;
  distance_ = length(away);
  azimuth_ = std::atan2(away.x, away.z);
  height_ = std::asin(std::clamp(away.y / distance_, -1.0, 1.0));
}

void Orbit::turn(double right, double up) {
  constexpr double kHighest = 89;
  azimuth_ += radians(right);
  height_ = std::clamp(height_ + radians(up), -radians(kHighest), radians(kHighest));
}

void Orbit::zoom(double factor) {
  const double farthest = reach_ * bounds_.radius - length(start_.target - bounds_.centre);
  const double nearest = 0.1 * bounds_.radius;
  distance_ = std::clamp(distance_ * factor, nearest, std::max(nearest, farthest));
}

View Orbit::view() const {
  CameraSpec camera;
  camera.has_eye = camera.has_target = true;
  camera.target = start_.target;
  camera.fov = start_.fov;
  camera.eye = start_.target + distance_ * Vec3{std::sin(azimuth_) * std::cos(height_), std::sin(height_),
                                                std::cos(azimuth_) * std::cos(height_)};
  return view_in_frame(camera, bounds_, height_px_, 0, "view");
}

}  // namespace spanline::host
