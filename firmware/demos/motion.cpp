#include "demos/motion.hpp"

#include "core/fx/bits.hpp"
#include "core/fx/sine.hpp"
#include "core/geom/camera.hpp"

namespace spanline::demos {

namespace {

std::int32_t times(Fx30 factor, std::int32_t value) {
  return static_cast<std::int32_t>(shift_round(std::int64_t{factor.raw} * value, 30));
}

// Turns (u, v) counter-clockwise.
template <int F>
void turn(Fixed<F>& u, Fixed<F>& v, Fx30 cos, Fx30 sin) {
  const Fixed<F> old = u;
  u.raw = times(cos, u.raw) - times(sin, v.raw);
  v.raw = times(sin, old.raw) + times(cos, v.raw);
}

}  // namespace

// matrix * R: a row's elements on the two other axes, taken as a vector, turn the other way round.
void spin(Transform& transform, Axis axis, Turn16 angle) {
  const Fx30 cos = cosine(angle), sin = sine(angle);
  const auto own = static_cast<unsigned>(axis);
  for (auto& row : transform.matrix) turn(row[(own + 1) % 3], row[(own + 2) % 3], cos, -sin);
}

Turn16 swing(Turn16 amplitude, Turn16 phase) {
  return {static_cast<std::uint16_t>(times(sine(phase), amplitude.raw))};
}

void orbit(CameraRecord& camera, const Fx16 (&target)[3], Turn16 aside) {
  Fx16 eye[3];
  for (unsigned i = 0; i < 3; ++i) eye[i] = camera.eye[i] - target[i];
  turn(eye[2], eye[0], cosine(aside), sine(aside));
  for (unsigned i = 0; i < 3; ++i) eye[i] = eye[i] + target[i];
  const Fx16 up[3] = {{}, Fx16::from_int(1), {}};
  // Keeps the camera as it was where there is no view from there: straight up or down.
  static_cast<void>(look_at(eye, target, up, camera.focal, camera.near_plane, camera.far_plane, camera));
}

}  // namespace spanline::demos
