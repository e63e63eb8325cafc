// From mesh units to the screen: composed matrices, clip space, projection.
//
// Clip space is chosen so that |x| <= w, |y| <= w is the guard band: kGuardPx pixels to each side of the screen's
// centre, wider than any screen. Depth is near / w, linear across the screen, as Q16.8: 65535.99 at the near plane,
// larger is nearer. Its resolution is 2^-24 of near^-1: two surfaces at distance d stay apart when they are d * d /
// near * 2^-24 apart.
#pragma once

#include <cstdint>
#include <type_traits>

#include "core/fx/bits.hpp"
#include "core/fx/reciprocal.hpp"
#include "core/geom/screen.hpp"
#include "core/scene/format.hpp"

namespace spanline {

inline constexpr std::int32_t kGuardPx = 1024;
static_assert(kMaxExtent / 2 < kGuardPx, "the guard band holds every screen");
static_assert((kMaxExtent / 2 + kGuardPx) * kSubpixels <= INT16_MAX, "a clipped vertex fits 28.4 in 16 bits");
inline constexpr int kDepthBits = 24;  // Q16.8

// A point in clip space: x right, y down, w the distance along the view direction; Q16.16, x and y in units of the
// guard band.
struct ClipPoint {
  std::int32_t x, y, w;
};

// Which planes a point lies outside of.
struct Outcode {
  enum : std::uint8_t { kNear = 1, kFar = 2, kLeft = 4, kRight = 8, kTop = 16, kBottom = 32 };
};

// A projected vertex as it is cached: 8 bytes.
struct ScreenPoint {
  ScreenXY at;                // valid where outcode is 0
  std::uint32_t depth : 24;   // Q16.8
  std::uint32_t outcode : 8;  // Outcode bits
};
static_assert(sizeof(ScreenPoint) == 8);

// Mesh units to clip space: clip = (linear * position) + offset.
struct ClipMatrix {
  std::int32_t linear[3][3];  // Q1.31 world units a mesh unit, rows x, y (scaled by the focal length) and w
  std::int32_t offset[3];     // Q16.16
  bool mirrored;              // the instance's transform turns fronts into clockwise

  // Point: a Position, or what lies a little outside the positions: |x|, |y|, |z| < 2^24 mesh units.
  template <typename Point>
  std::int32_t row(int i, const Point& p) const {
    // The offset and the rounding begin the sum, which is then one chain of multiply-adds.
    const std::int64_t sum = std::int64_t{offset[i]} * (1 << 15) + (1 << 14) + std::int64_t{linear[i][0]} * p.x +
                             std::int64_t{linear[i][1]} * p.y + std::int64_t{linear[i][2]} * p.z;  // Q17.31
    return saturate32(sum >> 15);
  }
  // How far from its offset a row may be, whatever the position (|position| <= 2^15).
  std::int64_t reach(int i) const {
    std::int64_t reach = 1;
    for (const std::int32_t c : linear[i]) reach += (c < 0 ? -std::int64_t{c} : c) + 1;
    return reach;
  }
  // Whether no position saturates.
  bool fits() const {
    for (int i = 0; i < 3; ++i) {
      if (farthest(i) > INT32_MAX) return false;
    }
    return true;
  }
  std::int64_t farthest(int i) const { return (offset[i] < 0 ? -std::int64_t{offset[i]} : offset[i]) + reach(i); }
  template <typename Point>
  ClipPoint operator()(const Point& p) const {
    return {row(0, p), row(1, p), row(2, p)};
  }
};

// A row of a matrix that fits(), made ready for many positions: at() is ClipMatrix::row(). In 64 bits,
class LongRow {
 public:
  LongRow() = default;
  LongRow(const ClipMatrix& matrix, int row)
      : start_(std::int64_t{matrix.offset[row]} * (1 << 15) + (1 << 14)),
        linear_{matrix.linear[row][0], matrix.linear[row][1], matrix.linear[row][2]} {}

  std::int32_t at(const Position& p) const {
    const std::int64_t sum =
        start_ + std::int64_t{linear_[0]} * p.x + std::int64_t{linear_[1]} * p.y + std::int64_t{linear_[2]} * p.z;
    return static_cast<std::int32_t>(sum >> 15);
  }

 private:
  std::int64_t start_ = 0;  // Q17.31
  std::int32_t linear_[3] = {0, 0, 0};
};

// or by products of 32 bits: with c = high * 2^15 + low, the sum of c * p over 2^15 is that of high * p, which wraps as
// it likes where the result fits, and that of low * p over 2^15.
class SplitRow {
 public:
  SplitRow() = default;
  SplitRow(const ClipMatrix& matrix, int row) : offset_(static_cast<std::uint32_t>(matrix.offset[row])) {
    for (int i = 0; i < 3; ++i) {
      const std::int32_t c = matrix.linear[row][i];
      const std::int32_t high = (c >> 15) + (c >> 14 & 1);
      high_[i] = static_cast<std::uint32_t>(high);
      low_[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(c) - (high_[i] << 15));  // -2^14 … 2^14 - 1
    }
  }

  std::int32_t at(const Position& p) const {
    static_assert(3 * (std::int64_t{1} << 14) * (1 << 15) + (1 << 14) <= INT32_MAX);
    const std::int32_t low = low_[0] * p.x + low_[1] * p.y + low_[2] * p.z + (1 << 14);
    const auto times = [](std::uint32_t c, std::int32_t v) { return c * static_cast<std::uint32_t>(v); };
    return static_cast<std::int32_t>(offset_ + times(high_[0], p.x) + times(high_[1], p.y) + times(high_[2], p.z) +
                                     static_cast<std::uint32_t>(low >> 15));
  }

 private:
  std::uint32_t offset_ = 0;  // Q16.16
  std::uint32_t high_[3] = {0, 0, 0};
  std::int32_t low_[3] = {0, 0, 0};
};

using ClipRow = std::conditional_t<kLongMultiply, LongRow, SplitRow>;

// A row for comparing, without products of 64 bits: at() is the row as Q(16 - up).(16 + up), off by less than kError.
class RoughRow {
 public:
  static constexpr std::int32_t kError = 1 << 16;

  // The most that positions of such a row (ClipMatrix::farthest) can go up.
  static int most_up(std::int32_t farthest) {
    int up = 0;
    while (up < 15 && farthest >> (29 - up) == 0) ++up;
    return up;
  }

  RoughRow() = default;
  RoughRow(const ClipMatrix& matrix, int row, int up) : offset_(matrix.offset[row] * (1 << up)) {
    // Three coefficients are off by half a unit each, times 2^15; row() rounds by half of 2^up more.
    static_assert(3 * (1 << 14) + (1 << 14) <= kError);
    for (int i = 0; i < 3; ++i) {
      const std::int32_t c = matrix.linear[row][i];
      linear_[i] = up == 15 ? c : (c >> (15 - up)) + (c >> (14 - up) & 1);
    }
  }

  // Sums wrap on the way.
  std::int32_t at(const Position& p) const {
    const auto times = [](std::int32_t c, std::int32_t v) {
      return static_cast<std::uint32_t>(c) * static_cast<std::uint32_t>(v);
    };
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(offset_) + times(linear_[0], p.x) +
                                     times(linear_[1], p.y) + times(linear_[2], p.z));
  }

 private:
  std::int32_t offset_ = 0, linear_[3] = {0, 0, 0};
};

// Combines camera, instance and mesh. Entries that would leave Q1.31 saturate: SceneView and the camera check keep them
// in.
ClipMatrix compose(const CameraRecord& camera, const Transform& transform, const MeshRecord& mesh);

// What the projection needs beside the matrix.
struct Projection {
  std::int32_t near_w;    // Q16.16
  std::int32_t far_w;     // Q16.16
  std::int32_t centre_x;  // 28.4 px
  std::int32_t centre_y;

  Projection(const CameraRecord& camera, const Screen& screen)
      : near_w(camera.near_plane.raw),
        far_w(camera.far_plane.raw),
        centre_x(screen.width * (kSubpixels / 2)),
        centre_y(screen.height * (kSubpixels / 2)) {}

  std::uint8_t outcode(const ClipPoint& p) const {
    std::uint8_t code = 0;
    if (p.w < near_w) code |= Outcode::kNear;
    if (p.w > far_w) code |= Outcode::kFar;
    if (p.x < -p.w) code |= Outcode::kLeft;
    if (p.x > p.w) code |= Outcode::kRight;
    if (p.y < -p.w) code |= Outcode::kTop;
    if (p.y > p.w) code |= Outcode::kBottom;
    return code;
  }

  // Whether outcode() is 0, without saying which plane it is.
  bool inside(const ClipPoint& p) const {
    const auto range = static_cast<std::uint32_t>(far_w - near_w);
    if (static_cast<std::uint32_t>(p.w) - static_cast<std::uint32_t>(near_w) > range) return false;
    const std::uint32_t w = static_cast<std::uint32_t>(p.w);
    return static_cast<std::uint32_t>(p.x) + w <= 2 * w && static_cast<std::uint32_t>(p.y) + w <= 2 * w;
  }

  // Whether a matrix takes all positions there are to points inside(); most do that have a mesh in view.
  bool holds(const ClipMatrix& matrix) const {
    const std::int64_t reach = matrix.reach(2), nearest = matrix.offset[2] - reach;
    return nearest >= near_w && matrix.offset[2] + reach <= far_w && matrix.farthest(0) <= nearest &&
           matrix.farthest(1) <= nearest;
  }

  // Projects a point inside all planes (outcode 0). At a distance of one world unit and more each coordinate is the
  // nearest 1/16 px to the exact one or, by the rounding of the matrix, its neighbour, and depth is within 1 of 65536;
  // nearer, errors grow as 1 / distance. The scene compiler picks the world's scale so that the near plane lies further
  // off.
  ScreenPoint operator()(const ClipPoint& p) const {
    Normaliser normaliser;
    const Inverse inverse(p.w, normaliser);
    ScreenPoint out;
    out.at = place(p, inverse);
    out.depth = depth_from(inverse) & 0xffffffu;
    out.outcode = 0;
    return out;
  }
  ScreenXY place(const ClipPoint& p, Normaliser& normaliser) const { return place(p, Inverse(p.w, normaliser)); }

  // Projects a point that rounding may have left a little outside of the planes.
  ScreenPoint clamped(const ClipPoint& p) const { return (*this)(inside(p) ? p : held(p)); }
  // The nearest point inside.
  ClipPoint held(ClipPoint p) const {
    const auto clamp = [](std::int32_t v, std::int32_t low, std::int32_t high) {
      return v < low ? low : v > high ? high : v;
    };
    p.w = clamp(p.w, near_w, far_w);
    p.x = clamp(p.x, -p.w, p.w);
    p.y = clamp(p.y, -p.w, p.w);
    return p;
  }

  // The depth of a point w ahead, inside the near plane; what the point's projection has.
  std::uint32_t depth(std::int32_t w, Normaliser& normaliser) const { return depth_from(Inverse(w, normaliser)); }
  std::uint32_t depth(std::int32_t w) const {
    Normaliser normaliser;
    return depth(w, normaliser);
  }

 private:
  struct Inverse {  // 1 / w = of * 2^up / 2^61
    Inverse(std::int32_t w, Normaliser& normaliser)
        : up(normaliser.up(static_cast<std::uint32_t>(w))),
          of(static_cast<std::int32_t>(reciprocal_normalised(static_cast<std::uint32_t>(w) << up))) {}
    int up;
    std::int32_t of;
  };
  ScreenXY place(const ClipPoint& p, const Inverse& inverse) const {
    const auto scaled = [&](std::int32_t v) {  // v / w * 2^14: 2^14 units of 28.4 are kGuardPx
      return shift_round(mul_high(v * (1 << inverse.up), inverse.of), 15);
    };
    static_assert(kGuardPx * kSubpixels == 1 << 14);
    return {static_cast<std::int16_t>(centre_x + scaled(p.x)), static_cast<std::int16_t>(centre_y + scaled(p.y))};
  }
  std::uint32_t depth_from(const Inverse& inverse) const {
    const std::int32_t depth = mul_high(near_w << inverse.up, inverse.of) >> (29 - kDepthBits);
    constexpr std::int32_t kNearest = (1 << kDepthBits) - 1;
    return static_cast<std::uint32_t>(depth < kNearest ? depth : kNearest);
  }
};

}  // namespace spanline
