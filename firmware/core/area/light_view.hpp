// Shadows (seed 2): what a light sees is lit. The scene is sorted as the light sees it, and the pieces that are left
// are carried back onto the polygons that they are of, where they are surface detail. What lies behind translucent
// polygons is lit through them: each part names them, so that the light may take their colours. A view a light; what
// the lights make of a place adds up.
#pragma once

#include "core/area/widest_triangle.hpp"
#include "core/area/window_sort.hpp"

namespace spanline::area {

// From the view of a light to a grid of a polygon's own, exactly: a point's barycentric coordinates among three corners
// that are known in both. They are three orientations of 2B + 1 bits, whose sum of products with coordinates fits 64.
class Carrier {
 public:
  // For each corner of the polygon in turn: where the light sees it, and where it lies in the polygon's own grid.
  void corner(GridPoint seen, GridPoint own) {
    if (const unsigned place = seen_.take(seen); place != WidestTriangle::kNone) own_[place] = own;
  }

  // Whether the light sees no area of the polygon: then nothing can be carried.
  bool flat() const { return seen_.flat(); }

  // A point of the polygon, to the nearest grid point of its own, halves upwards.
  GridPoint operator()(GridPoint p) const {
    const auto& [a, b, c] = seen_.corners();
    const std::int64_t share[] = {orientation(p, b, c), orientation(a, p, c), orientation(a, b, p)};
    const std::int64_t whole = orientation(a, b, c);
    const auto mix = [&](std::int16_t GridPoint::*axis) {
      std::int64_t sum = 0;
      for (unsigned i = 0; i < 3; ++i) sum += share[i] * (own_[i].*axis);
      const std::int64_t mean = whole > 0 ? round_div<std::int64_t>(sum, whole) : round_div<std::int64_t>(-sum, -whole);
      return static_cast<std::int16_t>(mean > kMaxCoordinate    ? kMaxCoordinate
                                       : mean < -kMaxCoordinate ? -kMaxCoordinate
                                                                : mean);
    };
    return {mix(&GridPoint::x), mix(&GridPoint::y)};
  }

 private:
  WidestTriangle seen_;
  GridPoint own_[3];
};

// `Scene` as for WindowSort, in the light's view (larger depth is nearer to the light), and carrier(i): the Carrier of
// a polygon. `sort` shows panes. Hands the lit parts to `sink`, a polygon's in any number of parts that do not overlap:
// begin_part(source), film(source) for each translucent polygon that the light comes through, begin_contour(),
// vertex(GridPoint, in the polygon's own grid)…, end_contour(); end_part(). Fails as WindowSort::solve() does.
template <typename Scene, typename Sink>
class LightView {
 public:
  LightView(const Scene& scene, Sink& sink) : scene_(scene), sink_(sink) {}

  Status solve(AreaSort& sort, PoolRef<std::uint16_t> names, std::uint32_t most, const Box& view) {
    CHECK(sort.panes() == Panes::shown);
    return WindowSort<Scene>(sort, names, most).solve(scene_, view, *this);
  }

  // What the sort hands out; between films and the background nothing is lit.
  void begin_piece(std::uint16_t source, const Plane&) {
    lit_ = source != kBackdrop;
    if (!lit_) return;
    carrier_ = scene_.carrier(source);
    sink_.begin_part(source);
  }
  void film(std::uint16_t source) {
    if (lit_) sink_.film(source);
  }
  void begin_contour() {
    if (lit_) sink_.begin_contour();
  }
  void vertex(GridPoint p) {
    if (lit_) sink_.vertex(carrier_(p));
  }
  void end_contour() {
    if (lit_) sink_.end_contour();
  }
  void end_piece() {
    if (lit_) sink_.end_part();
  }

 private:
  const Scene& scene_;
  Sink& sink_;
  Carrier carrier_;
  bool lit_ = false;
};

}  // namespace spanline::area
