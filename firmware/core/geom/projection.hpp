// From mesh units to the screen: composed matrices, clip space, projection.
//
// Clip space is chosen so that |x| <= w, |y| <= w is the guard band: kGuardPx pixels to each side of the screen's
// centre, wider than any screen. Depth is near / w, linear across the screen, as Q16.8: 65535.99 at the near plane,
// larger is nearer. Its resolution is 2^-24 of near^-1: two surfaces at distance d stay apart when they are d * d /
// near * 2^-24 apart.
#pragma once

#include <cstdint>

#include "core/fx/bits.hpp"
#include "core/fx/reciprocal.hpp"
#include "core/geom/clip_matrix.hpp"
#include "core/geom/screen.hpp"

namespace spanline {

inline constexpr std::int32_t kGuardPx = 1024;
static_assert(kMaxExtent / 2 < kGuardPx, "the guard band holds every screen");
static_assert((kMaxExtent / 2 + kGuardPx) * kSubpixels <= INT16_MAX, "a clipped vertex fits 28.4 in 16 bits");
inline constexpr int kDepthBits = 24;  // Q16.8

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

// Combines camera, instance and mesh. Entries that would leave Q1.31 saturate: SceneView and the camera check keep them
// in.
ClipMatrix compose(const CameraRecord& camera, const Transform& transform, const MeshRecord& mesh);
// Whether an instance's transform turns fronts into clockwise.
bool is_mirrored(const Transform& transform);

// What the projection needs beside the matrix.
struct Projection {
  std::int32_t near_w;    // Q16.16
  std::int32_t far_w;     // Q16.16
  std::int32_t centre_x;  // 28.4 px
  std::int32_t centre_y;

  static constexpr std::int32_t kWellAhead = 1 << 10, kRounding = 4;  // Q16.16

  constexpr Projection(const CameraRecord& camera, const Screen& screen)
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
    return between_sides(p, static_cast<std::uint32_t>(p.w));
  }
  // Whether outcode() is 0 and there is a little space to the guard band's sides: points on the screen of which this is
  // true differ by less than 2^15 units of 28.4 each way; and
  // to the near plane, as rounding is to stay inside.
  bool well_inside(const ClipPoint& p) const {
    const std::int32_t ahead = (near_w < INT32_MAX - kRounding ? near_w : INT32_MAX - kRounding) + kRounding;
    const std::int32_t nearest = ahead > kWellAhead ? ahead : kWellAhead;
    if (p.w < nearest || p.w > far_w) return false;
    return between_sides(p, static_cast<std::uint32_t>(p.w - (p.w >> 8)));
  }
  // What is true of all corners of a box is so of what lies between them, as far as it matters: rounding takes less
  // than kRounding units, of at least kWellAhead >> 8.
  bool well_inside(const PositionBox& box, const ClipRows& to_clip) const;
  bool well_inside(Slice<const Position> positions, const ClipRows& to_clip) const;
  // Places positions inside all planes one after another.
  void place(Slice<const Position> positions, const ClipRows& to_clip, ScreenXY* at) const;

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
  // The same by words, `rest` in the bits above the depth: for many, which a table of 512 bytes is worth while for.
  void put(const ClipPoint& p, std::uint32_t rest, std::uint32_t& at, std::uint32_t& depth) const {
    Normaliser normaliser;
    const int up = normaliser.up(static_cast<std::uint32_t>(p.w));
    const Inverse inverse(
        up, static_cast<std::int32_t>(reciprocal_normalised<true>(static_cast<std::uint32_t>(p.w) << up)));
    at = pack_halves_of_q15(placed(centre_x, p.x, inverse), placed(centre_y, p.y, inverse));
    depth = depth_from(inverse) | rest;
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
  static bool between_sides(const ClipPoint& p, std::uint32_t side) {
    return static_cast<std::uint32_t>(p.x) + side <= 2 * side && static_cast<std::uint32_t>(p.y) + side <= 2 * side;
  }
  struct Inverse {  // 1 / w = of * 2^up / 2^61
    Inverse(std::int32_t w, Normaliser& normaliser)
        : up(normaliser.up(static_cast<std::uint32_t>(w))),
          of(static_cast<std::int32_t>(reciprocal_normalised(static_cast<std::uint32_t>(w) << up))) {}
    Inverse(int bits_up, std::int32_t inverse) : up(bits_up), of(inverse) {}
    int up;
    std::int32_t of;
  };
  // To v / w * 2^14, which fifteen bits follow: 2^14 units of 28.4 are kGuardPx.
  static std::int32_t placed(std::int32_t centre, std::int32_t v, const Inverse& inverse) {
    static_assert(kGuardPx * kSubpixels == 1 << 14);
    static_assert((kMaxExtent * std::int64_t{kSubpixels / 2} + (1 << 14)) * (1 << 15) + (1 << 14) <= INT32_MAX);
    return add_high(v * (1 << inverse.up), inverse.of, centre * (1 << 15) + (1 << 14));
  }
  ScreenXY place(const ClipPoint& p, const Inverse& inverse) const {
    const std::int32_t x = placed(centre_x, p.x, inverse), y = placed(centre_y, p.y, inverse);
    return PackedXY(pack_halves(x >> 15, y >> 15)).unpacked();
  }
  std::uint32_t depth_from(const Inverse& inverse) const {
    return saturate<kDepthBits>(mul_high(near_w << inverse.up, inverse.of) >> (29 - kDepthBits));
  }
};

}  // namespace spanline
