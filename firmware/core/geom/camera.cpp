#include "core/geom/camera.hpp"

#include <bit>

#include "core/fx/bits.hpp"
#include "core/fx/root.hpp"
#include "core/geom/projection.hpp"

namespace spanline {

namespace {

constexpr Status bad_camera(const char* field) { return {Code::bad_argument, "camera", field, 0, 0, 0, 0}; }

struct Vector {
  std::int64_t v[3];  // any common scale
};

// Scales a vector to unit length in Q2.30; false where it vanishes. The components are first brought to 30 bits, so
// that their squares fit 64.
bool normalise(const Vector& in, Fx30 (&out)[3]) {
  std::uint64_t largest = 0;
  for (const std::int64_t c : in.v) largest |= static_cast<std::uint64_t>(c < 0 ? -c : c);
  if (largest == 0) return false;
  const int up = 30 - static_cast<int>(std::bit_width(largest));
  std::int64_t c[3];
  for (int i = 0; i < 3; ++i) c[i] = up >= 0 ? in.v[i] * (std::int64_t{1} << up) : in.v[i] >> -up;
  const auto square = static_cast<std::uint64_t>(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
  const auto length = static_cast<std::int64_t>(square_root(square));
  for (int i = 0; i < 3; ++i)
    out[i].raw = static_cast<std::int32_t>(round_div<std::int64_t>(c[i] * Fx30::kOne, length));
  return true;
}

Vector cross(const Fx30 (&a)[3], const Fx30 (&b)[3]) {
  Vector out;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    out.v[i] = (std::int64_t{a[j].raw} * b[k].raw - std::int64_t{a[k].raw} * b[j].raw) >> 1;
  }
  return out;
}

// matrix (Q16.16) times mesh unit (Q1.31) as Q1.31.
void scale_to_world(const Transform& transform, std::int32_t unit, std::int32_t (&world)[3][3]) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      world[i][j] = saturate32(shift_round(std::int64_t{transform.matrix[i][j].raw} * unit, 16));
    }
  }
}

bool is_mirrored(const Transform& transform) {
  const auto m = [&](int i, int j) {
    return std::int64_t{transform.matrix[i][j].raw} >> 6;
  };  // Q22.10: products fit 64
  std::int64_t determinant = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    determinant += m(0, i) * (((m(1, j) * m(2, k)) >> 10) - ((m(1, k) * m(2, j)) >> 10));
  }
  return determinant < 0;
}

}  // namespace

Status look_at(const Fx16 (&eye)[3], const Fx16 (&target)[3], const Fx16 (&up)[3], Fx12 focal, Fx16 near_plane,
               Fx16 far_plane, CameraRecord& camera) {
  CameraRecord result;
  Vector back, upward;
  for (int i = 0; i < 3; ++i) {
    result.eye[i] = eye[i];
    back.v[i] = std::int64_t{eye[i].raw} - target[i].raw;
    upward.v[i] = up[i].raw;
  }
  Fx30 up_unit[3];
  if (!normalise(back, result.axes[2])) return bad_camera("target");
  if (!normalise(upward, up_unit)) return bad_camera("up");
  if (!normalise(cross(up_unit, result.axes[2]), result.axes[0])) return bad_camera("up");
  normalise(cross(result.axes[2], result.axes[0]), result.axes[1]);
  result.focal = focal;
  result.near_plane = near_plane;
  result.far_plane = far_plane;
  const Status status = check_camera(result);
  if (status.ok()) camera = result;
  return status;
}

[[gnu::cold]] Status check_camera(const CameraRecord& camera) {
  for (const Fx16 c : camera.eye) {
    if (c > Fx16::from_int(2 * kMaxWorld) || c < Fx16::from_int(-2 * kMaxWorld)) return bad_camera("eye");
  }
  for (const auto& row : camera.axes) {
    std::int64_t square = 0;
    for (const Fx30 c : row) square += shift_round(std::int64_t{c.raw} * c.raw, 30);
    constexpr std::int64_t kSlack = Fx30::kOne >> 10;
    if (square < Fx30::kOne - kSlack || square > Fx30::kOne + kSlack) return bad_camera("axes");
  }
  if (camera.focal.raw <= 0 || camera.focal > Fx12::from_int(kMaxFocalPx)) return bad_camera("focal");
  if (camera.near_plane.raw <= 0) return bad_camera("near_plane");
  if (camera.far_plane <= camera.near_plane) return bad_camera("far_plane");
  return {};
}

[[gnu::cold]] ClipMatrix compose(const CameraRecord& camera, const Transform& transform, const MeshRecord& mesh) {
  std::int32_t world[3][3];
  scale_to_world(transform, mesh.unit, world);
  std::int64_t from_eye[3];  // Q16.16: the mesh's origin seen from the eye
  for (int i = 0; i < 3; ++i) {
    std::int64_t sum = 0;
    for (int k = 0; k < 3; ++k) sum += shift_round(std::int64_t{transform.matrix[i][k].raw} * mesh.origin[k].raw, 16);
    from_eye[i] = saturate32(sum + transform.translation[i].raw - camera.eye[i].raw);
  }
  // focal px in units of the guard band: focal / kGuardPx, so Q20.12 becomes Q10.22. The screen's y points down, w
  // ahead.
  const std::int64_t focal = camera.focal.raw;
  const std::int64_t scale[3] = {focal, -focal, -(std::int64_t{kGuardPx} << 12)};
  ClipMatrix out;
  for (int row = 0; row < 3; ++row) {
    for (int j = 0; j < 3; ++j) {
      std::int64_t sum = 0;  // Q3.61
      for (int k = 0; k < 3; ++k) sum += std::int64_t{camera.axes[row][k].raw} * world[k][j];
      out.linear[row][j] = saturate32(shift_round(shift_round(sum, 30) * scale[row], 22));
    }
    std::int64_t dot = 0;  // Q46
    for (int k = 0; k < 3; ++k) dot += std::int64_t{camera.axes[row][k].raw} * from_eye[k];
    out.offset[row] = saturate32(shift_round(shift_round(dot, 24) * scale[row], 28));
  }
  out.mirrored = is_mirrored(transform);
  return out;
}

}  // namespace spanline
