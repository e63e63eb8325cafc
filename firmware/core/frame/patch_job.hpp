// A patch at work: where it lies on the screen, and what is wanted of it.
#pragma once

#include "core/curve/dice.hpp"
#include "core/curve/normals.hpp"
#include "core/geom/facet.hpp"
#include "core/shade/light.hpp"
#include "core/vsg/grid_start.hpp"

namespace spanline {

// What a patch looks like.
struct PatchLook {
  const LightRig* lights;
  const MaterialRecord* material;
  PixelFormat format;
  bool gouraud;    // keep normals, not colours
  bool two_sided;  // keep backs
};

// What something covers at most, 28.4.
struct ScreenBounds {
  static constexpr std::int32_t kFar = 1 << 16;  // off every screen
  static constexpr ScreenBounds anywhere() { return {-kFar, kFar, -kFar, kFar}; }

  std::int32_t top = kFar, bottom = -kFar, left = kFar, right = -kFar;

  ScreenBounds() = default;
  constexpr ScreenBounds(std::int32_t t, std::int32_t b, std::int32_t l, std::int32_t r)
      : top(t), bottom(b), left(l), right(r) {}
  explicit ScreenBounds(const PackedBox& points)
      : ScreenBounds(points.low.y(), points.high.y(), points.low.x(), points.high.x()) {}

  void widen(const ScreenBounds& other) {
    if (other.top < top) top = other.top;
    if (other.bottom > bottom) bottom = other.bottom;
    if (other.left < left) left = other.left;
    if (other.right > right) right = other.right;
  }
  void widen(ScreenXY p) { widen({p.y, p.y, p.x, p.x}); }
  // Of all between points that this is of: rounding may put a vertex so far out of the hull of the control points.
  ScreenBounds of_hull() const { return {top - 2, bottom + 2, left - 2, right + 2}; }
};

// What is worked for: lines of a band, columns of the screen.
struct PatchWindow {
  std::int32_t top, bottom, width;

  // Whether all of it may be seen.
  bool holds(const ScreenBounds& b) const {
    return first_centre(b.top) >= top && first_centre(b.bottom) <= bottom && b.left >= 0 &&
           first_centre(b.right) <= width;
  }
  // Whether the centre of a pixel of it may be covered.
  bool meets(const ScreenBounds& b) const {
    const std::int32_t first = first_centre(b.top), end = first_centre(b.bottom);
    const std::int32_t left = first_centre(b.left), right = first_centre(b.right);
    return first < end && first < bottom && end > top && left < right && left < width && right > 0;
  }
};

// Which triangles of a cell (a, b, c, d) of the grid are facets. A cell that is convex on the screen is one facet, of
// four corners. Another one is two triangles, abc and acd, each of which may turn its back: a quadrangle that crosses
// itself is not to be drawn, and every line of the screen meets no more than two edges of a facet.
struct CellParts {
  enum : std::uint8_t {
    kNone = 0,
    kUpper = CellCovers::kUpper,
    kLower = CellCovers::kLower,
    kQuad = kUpper | kLower,
    kApart = CellCovers::kApart
  };

  // Those that turn their fronts to the viewer, `two_sided`: all. `mirrored`: fronts run clockwise. kNear: the corners
  // differ by less than 2^15 units each way.
  template <bool kNear = false>
  static std::uint8_t of(PackedXY a, PackedXY b, PackedXY c, PackedXY d, bool mirrored, bool two_sided) {
    // Doubled, negative for fronts; a b c + a c d = a b d + b c d.
    std::int32_t abc, acd, abd;
    if constexpr (kNear && kDualMultiply) {
      const std::uint32_t ab = subtract_halves(b.word, a.word), ac = subtract_halves(c.word, a.word),
                          ad = subtract_halves(d.word, a.word);
      abc = cross_halves(ab, ac);
      acd = cross_halves(ac, ad);
      abd = cross_halves(ab, ad);
    } else {
      abc = doubled_area(a, b, c);
      acd = doubled_area(a, c, d);
      abd = doubled_area(a, b, d);
    }
    if (mirrored) {
      abc = -abc;
      acd = -acd;
      abd = -abd;
    }
    const auto bcd = static_cast<std::int32_t>(static_cast<std::uint32_t>(abc) + static_cast<std::uint32_t>(acd) -
                                               static_cast<std::uint32_t>(abd));
    const std::int32_t any = abc | acd | abd | bcd;
    if (any >= 0) return two_sided && any != 0 ? kQuad : kNone;
    if ((abc & acd & abd & bcd) < 0) return kQuad;
    if (abc <= 0 && acd <= 0 && abd <= 0 && bcd <= 0) return kQuad;
    const bool upper = two_sided ? abc != 0 : abc < 0, lower = two_sided ? acd != 0 : acd < 0;
    if (!upper && !lower) return kNone;
    return static_cast<std::uint8_t>((upper ? kUpper : 0) | (lower ? kLower : 0) | kApart);
  }
};

// The reader's current face, a patch, as it is diced for a window.
struct PatchJob {
  const FacetReader& reader;
  const PatchLook& look;
  PatchWindow window;
  ClipPatch patch;
  union {               // not cleared before it is made
    ScreenXY at[4][4];  // its control points on the screen; kNotProjected before the near plane
  };
  ScreenBounds bounds;
  bool behind = false;      // some control point lies before the near plane: its bounds say nothing
  bool outside = false;     // some control point lies outside of some plane
  bool well_inside = true;  // Projection::well_inside() is true of all control points, and of what lies between them
  bool nothing = false;     // nothing of the patch can be seen
  bool whole = false;       // all of it lies in the window
  bool turned = false;      // `patch` is the face by a quarter
  PatchDicer* dicer = nullptr;
  const PatchTangents* tangents = nullptr;  // at the corners of facets

  PatchJob(const FacetReader& facets, const PatchLook& patch_look, const PatchWindow& w);
  std::uint32_t rows() const { return dicer->rows(); }
  std::uint32_t columns() const { return dicer->columns(); }
  ScreenBounds bounds_of(const GridRow& row) const;
  PatchDicer make_dicer(const DiceView& view) const { return {patch, at, view}; }
  // Made for the corners of facets.
  PatchTangents tangents_of_corners() const;

 private:
  [[gnu::noinline]] void project_held();
};

}  // namespace spanline
