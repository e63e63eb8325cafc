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

Fx16 dot(const Fx16 (&a)[3], const Fx16 (&b)[3]) {
  std::int64_t sum = 0;
  for (unsigned i = 0; i < 3; ++i) sum += std::int64_t{a[i].raw} * b[i].raw;
  return Fx16::from_raw(static_cast<std::int32_t>(shift_round(sum, 16)));
}

}  // namespace

// world = R (M p - M o) + M o + t: the matrix is R M, and t grows by (M - R M) o.
void spin(InstanceRecord& instance, const Fx16 (*origins)[3], Axis axis, Turn16 angle) {
  Transform& transform = instance.transform;
  const auto& origin = origins[instance.mesh];
  Fx16 before[3];
  for (unsigned i = 0; i < 3; ++i) before[i] = dot(transform.matrix[i], origin);
  auto& u = transform.matrix[(static_cast<unsigned>(axis) + 1) % 3];
  auto& v = transform.matrix[(static_cast<unsigned>(axis) + 2) % 3];
  for (unsigned column = 0; column < 3; ++column) turn(u[column], v[column], cosine(angle), sine(angle));
  for (unsigned i = 0; i < 3; ++i) {
    transform.translation[i] = transform.translation[i] + before[i] - dot(transform.matrix[i], origin);
  }
}

Turn16 swing(Turn16 amplitude, Turn16 phase) { return {static_cast<std::uint16_t>(times(sine(phase), amplitude.raw))}; }

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
