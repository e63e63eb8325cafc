#include "core/geom/camera.hpp"

#include <bit>
#include <type_traits>

#include "core/fx/bits.hpp"
#include "core/fx/root.hpp"
#include "core/geom/projection.hpp"

namespace spanline {

namespace {

Status bad_camera(const char* field) { return bad_argument("camera", field); }

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

// These two are short only where they stand once.
[[gnu::cold, gnu::noinline]] std::int32_t saturated(std::int64_t value) { return saturate32(value); }
// value / 2^down to the nearest, ties up; down > 0.
[[gnu::cold, gnu::noinline]] std::int64_t rounded(std::int64_t value, int down) {
  return ((value >> (down - 1)) + 1) >> 1;
}

// Q16.16 times any format, in that.
std::int64_t product(Fx16 a, std::int32_t b) { return shift_round(std::int64_t{a.raw} * b, 16); }

// Which is out of its range; null: none.
const char* wrong_field(const CameraRecord& camera) {
  for (const Fx16 c : camera.eye) {
    if (c > Fx16::from_int(2 * kMaxWorld) || c < Fx16::from_int(-2 * kMaxWorld)) return "eye";
  }
  for (const auto& row : camera.axes) {
    std::int64_t square = 0;  // Q6.58
    for (const Fx30 c : row) square += std::int64_t{c.raw} * c.raw >> 2;
    constexpr std::int32_t kOne = 1 << 26, kSlack = kOne >> 10;
    const std::int32_t off = static_cast<std::int32_t>(square >> 32) - kOne;
    if (off < -kSlack || off > kSlack) return "axes";
  }
  if (camera.focal.raw <= 0 || camera.focal > Fx12::from_int(kMaxFocalPx)) return "focal";
  if (camera.near_plane.raw <= 0) return "near_plane";
  return camera.far_plane <= camera.near_plane ? "far_plane" : nullptr;
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

// Not cold, as others that return a Status: one that is well would be cleared by memset(), 164 bytes.
Status check_camera(const CameraRecord& camera) {
  const char* const wrong = wrong_field(camera);
  return wrong == nullptr ? Status{} : bad_camera(wrong);
}

[[gnu::cold]] bool same_camera(const CameraRecord& a, const CameraRecord& b) {
  static_assert(std::has_unique_object_representations_v<CameraRecord>, "so bytes tell");
  const auto *x = reinterpret_cast<const std::uint8_t*>(&a), *y = reinterpret_cast<const std::uint8_t*>(&b);
  const std::uint8_t* const end = x + sizeof(CameraRecord);
  while (x != end && *x == *y) ++x, ++y;
  return x == end;
}

[[gnu::cold]] ClipMatrix compose(const CameraRecord& camera, const Transform& transform, const MeshRecord& mesh) {
  // focal px in units of the guard band: focal / kGuardPx, so Q20.12 becomes Q10.22. The screen's y points down, w
  // ahead.
  const std::int32_t focal = camera.focal.raw;
  const std::int32_t scale[3] = {focal, -focal, -(kGuardPx << 12)};
  ClipMatrix out;
  for (int column = 0; column < 4; ++column) {
    const bool origin = column == 3;
    std::int32_t world[3];  // what a mesh unit comes to, Q1.31; or the mesh's origin seen from the eye, Q16.16
    for (int i = 0; i < 3; ++i) {
      const Fx16(&row)[3] = transform.matrix[i];
      std::int64_t sum = 0;
      if (!origin) {
        sum = product(row[column], mesh.unit);
      } else {
        for (int k = 0; k < 3; ++k) sum += product(row[k], mesh.origin[k].raw);
        sum += std::int64_t{transform.translation[i].raw} - camera.eye[i].raw;
      }
      world[i] = saturated(sum);
    }
    for (int row = 0; row < 3; ++row) {
      std::int64_t dot = 0;  // Q3.61; Q46
      for (int k = 0; k < 3; ++k) dot += std::int64_t{camera.axes[row][k].raw} * world[k];
      // 52 bits less, of which six go before the one is scaled, and after that of the other.
      const int early = origin ? 24 : 30;
      const std::int32_t clip = saturated(rounded(rounded(dot, early) * scale[row], 52 - early));
      (origin ? out.offset[row] : out.linear[row][column]) = clip;
    }
  }
  return out;
}

[[gnu::cold]] bool is_mirrored(const Transform& transform) {
  const auto m = [&](int i, int j) {
    return std::int64_t{transform.matrix[i][j].raw} >> 6;
  };  // Q22.10: products fit 64
  std::int64_t determinant = 0;
  for (int i = 0, j = 1, k = 2; i < 3; j = k, k = i++) {
    determinant += m(0, i) * (((m(1, j) * m(2, k)) >> 10) - ((m(1, k) * m(2, j)) >> 10));
  }
  return determinant < 0;
}

}  // namespace spanline
