// Gouraud's shading of triangles in light of one hue (LightHue): brightness is a plane over the screen, and a table
// turns it into colours.
#pragma once

#include <bit>

#include "core/base/pool.hpp"
#include "core/geom/gradient.hpp"
#include "core/geom/screen.hpp"
#include "core/scene/format.hpp"
#include "core/vsg/active_edge.hpp"
#include "core/vsg/depth.hpp"

namespace spanline {

// Brightness at a vertex, 0 … kFullBrightness.
using Brightness = std::uint8_t;
inline constexpr std::uint32_t kFullBrightness = 252;
inline constexpr int kBrightnessStep = 2;  // bits below an entry of the table

// Brightness over a triangle, in table entries Q6.26 modulo 2^32, half an entry added so that cutting off rounds. The
// word is full, so whatever it holds is an entry of the table.
struct BrightnessPlane {
  static constexpr int kFraction = 26;
  std::uint32_t at_zero, right, down;  // at column 0 and line 0; a column; a line
  std::uint32_t at(std::uint32_t column, std::uint32_t line) const { return at_zero + right * column + down * line; }
  static constexpr std::uint32_t entry(std::uint32_t brightness) { return brightness >> kFraction; }
};

namespace detail {
// Gradients are made with fewer bits than the plane has, which leaves room for the steps of slivers.
inline constexpr int kBrightnessBits = 16;
}  // namespace detail

// The plane through three corners; inside the triangle it comes round neither end of the table.
inline BrightnessPlane brightness_plane(const ScreenXY (&at)[3], const Brightness (&corner)[3]) {
  constexpr int kBits = detail::kBrightnessBits, kToPlane = BrightnessPlane::kFraction - kBrightnessStep - kBits;
  static constexpr Screen kAny{kMaxExtent, kMaxExtent};  // wherever it lies, it is off by little
  const DepthPlane plane = value_plane(at, {corner[0], corner[1], corner[2]}, kBits, kAny);
  constexpr std::uint32_t kHalfEntry = 1u << (kBrightnessStep + kBits - 1);
  return {(plane.ramp.at_zero + kHalfEntry) << kToPlane, plane.ramp.slope << kToPlane, plane.down << kToPlane};
}

// Likewise of a cell of four corners in the view, convex and run either way round, whose brightness need not lie in a
// plane: it grows along the diagonals as between the corners, and is off by as much at all four, half of what the
// diagonals differ by where they cross. So much less is it off where it would leave the table.
BrightnessPlane cell_brightness(const ScreenXY (&at)[4], const Brightness (&corner)[4]);

// The colours of one material, darkest first, as Painter::fill takes them.
struct ColorTable {
  static constexpr std::uint32_t kEntries = 64;
  std::uint16_t material;
  std::uint16_t colors[kEntries];
};
static_assert(kFullBrightness >> kBrightnessStep == ColorTable::kEntries - 1);
static_assert(BrightnessPlane::entry(UINT32_MAX) == ColorTable::kEntries - 1);

// How a face looks that was met lately: its brightness over a material, or one colour.
struct FaceLook {
  BrightnessPlane plane;
  FaceId face;
  std::uint16_t material;

  // Of one colour; of no face at all: more materials than the latter's number are not drawn.
  static constexpr std::uint16_t kNoMaterial = 0xffff, kUnknown = kNoMaterial - 2;
  static constexpr FaceLook flat(std::uint16_t color, FaceId face = 0) { return {{0, color, 0}, face, kNoMaterial}; }
  bool smooth() const { return material != kNoMaterial; }
  bool flat_of(FaceId f) const { return face == f && !smooth(); }
  std::uint16_t color() const { return static_cast<std::uint16_t>(plane.right); }  // where not smooth
};
static_assert(sizeof(FaceLook) == 16);

// The place of a face among those that are kept, in the lowest bits. Faces that meet a line often have numbers that are
// a power of two apart.
constexpr std::uint32_t face_place(FaceId face) { return face + (std::uint32_t{face} >> 5); }

// What Gouraud's shading uses; without looks everything is flat.
struct SmoothStorage {
  PoolRef<FaceLook> looks;
  PoolRef<ColorTable> tables;
};

// The looks and tables made last: tables each in the place that its number gives it, looks there or by turns.
class SmoothCache {
 public:
  static constexpr std::uint32_t kMostLooks = 254;  // that are used

  SmoothCache() = default;
  constexpr SmoothCache(const SmoothStorage& storage, PixelFormat format)
      : looks_(storage.looks),
        tables_(storage.tables),
        table_mask_(std::bit_floor(storage.tables.capacity() + 1u) - 1u),
        format_(format) {
    looks_.limit(kMostLooks);
    look_mask_ = std::bit_floor(looks_.capacity() + 1u) - 1u;
  }

  constexpr bool on() const { return looks_.capacity() != 0; }
  FaceLook* looks() const { return on() ? &looks_[0] : nullptr; }  // by the slots of faces

  // At the beginning of a frame.
  void clear();

  // The face's look; make(face) where it is not here. Valid until the next call.
  template <typename Make>
  const FaceLook& look(FaceId face, const Make& make) {
    FaceLook& look = looks_[face_place(face) & look_mask_];
    if (look.face != face) {
      look = make(face);
      look.face = face;
    }
    return look;
  }
  // The same where each face has a slot for the number of its look: the look made first gives way, and make(face, look)
  // makes all of it in its place. 0: none made yet.
  template <typename Make>
  const FaceLook& look(FaceId face, std::uint8_t& slot, const Make& make) {
    FaceLook* look = &looks_[slot];
    if (look->face != face) {
      oldest_ = oldest_ == looks_.capacity() ? std::uint8_t{1} : static_cast<std::uint8_t>(oldest_ + 1);
      slot = oldest_;
      look = &looks_[oldest_];
      make(face, *look);
    }
    return *look;
  }
  // Likewise a material's colours in the light of the scene.
  template <bool kPlain = false>
  const std::uint16_t* colors(std::uint16_t material, const SceneRecord& scene) {
    ColorTable& table = tables_[material & table_mask_];
    if (table.material != material) kPlain ? fill_plain(table, material, scene) : fill(table, material, scene);
    return table.colors;
  }

 private:
  void fill(ColorTable& table, std::uint16_t material, const SceneRecord& scene);
  // The same of a plain scene (Budget::plain).
  static void fill_plain(ColorTable& table, std::uint16_t material, const SceneRecord& scene);

  PoolRef<FaceLook> looks_;
  PoolRef<ColorTable> tables_;
  std::uint32_t look_mask_ = 0, table_mask_ = 0;
  std::uint8_t oldest_ = 0;
  PixelFormat format_ = PixelFormat::rgb565;
};

}  // namespace spanline
