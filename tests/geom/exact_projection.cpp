#include "geom/exact_projection.hpp"

namespace spanline::test {
namespace {

using Real = long double;

template <int F>
Real real(Fixed<F> value) {
  return static_cast<Real>(value.raw) / static_cast<Real>(std::int64_t{1} << F);
}

}  // namespace

EyePoint seen_from(const CameraRecord& camera, const InstanceRecord& instance, const MeshRecord& mesh,
                   const Position& position) {
  const Real unit = static_cast<Real>(mesh.unit) / static_cast<Real>(std::int64_t{1} << 31);
  const std::int16_t raw[3] = {position.x, position.y, position.z};
  Real local[3];
  for (int i = 0; i < 3; ++i) local[i] = real(mesh.origin[i]) + unit * raw[i];
  Real from_eye[3];
  for (int i = 0; i < 3; ++i) {
    from_eye[i] = real(instance.transform.translation[i]) - real(camera.eye[i]);
    for (int k = 0; k < 3; ++k) from_eye[i] += real(instance.transform.matrix[i][k]) * local[k];
  }
  Real along[3] = {0, 0, 0};
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) along[row] += real(camera.axes[row][k]) * from_eye[k];
  }
  return {along[0], along[1], -along[2]};
}

ExactPoint project(const EyePoint& point, const CameraRecord& camera, int width, int height) {
  const Real scale = 16 * real(camera.focal) / point.ahead;
  return {8 * static_cast<Real>(width) + point.right * scale, 8 * static_cast<Real>(height) - point.up * scale,
          65536 * real(camera.near_plane) / point.ahead};
}

}  // namespace spanline::test
