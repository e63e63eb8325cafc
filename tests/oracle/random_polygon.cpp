#include "oracle/random_polygon.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace spanline::oracle {
namespace {

constexpr int kUnit = 1 << 14;  // shapes are made in the square ±kUnit, then mapped to their place

int in_16_bits(std::int64_t value) {
  return static_cast<int>(std::clamp<std::int64_t>(value, std::numeric_limits<std::int16_t>::min(),
                                                   std::numeric_limits<std::int16_t>::max()));
}

std::int64_t turn_of(const Point& a, const Point& b, const Point& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

int sign(std::int64_t value) { return value < 0 ? -1 : value > 0 ? 1 : 0; }

bool in_box(const Point& a, const Point& b, const Point& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool touch(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int abc = sign(turn_of(a, b, c));
  const int abd = sign(turn_of(a, b, d));
  const int cda = sign(turn_of(c, d, a));
  const int cdb = sign(turn_of(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && in_box(a, b, c)) || (abd == 0 && in_box(a, b, d)) || (cda == 0 && in_box(c, d, a)) ||
         (cdb == 0 && in_box(c, d, b));
}

// Two edges from `corner` that run along each other.
bool folds(const Point& corner, const Point& a, const Point& b) {
  const std::int64_t along = (std::int64_t{a.x} - corner.x) * (std::int64_t{b.x} - corner.x) +
                             (std::int64_t{a.y} - corner.y) * (std::int64_t{b.y} - corner.y);
  return turn_of(corner, a, b) == 0 && along >= 0;
}

struct Side {
  std::size_t contour;
  Point from, to;
};

std::vector<Side> sides_of(const std::vector<Contour>& contours) {
  std::vector<Side> sides;
  for (std::size_t ring = 0; ring < contours.size(); ++ring) {
    const Contour& contour = contours[ring];
    for (std::size_t i = 0; i < contour.size(); ++i) {
      sides.push_back({ring, contour[i], contour[(i + 1) % contour.size()]});
    }
  }
  return sides;
}

std::vector<int> sorted_turns(Random& random, int count) {
  std::vector<int> turns;
  turns.reserve(static_cast<std::size_t>(count));
  const int start = random.below(1024);
  for (int i = 0; i < count; ++i) turns.push_back(start + (1024 * i + random.below(900)) / count);
  return turns;
}

Point on_circle(int turn, int radius) {
  const Point p = circle_point(turn);
  return {p.x * radius / kUnit, p.y * radius / kUnit};
}

Contour convex(Random& random, int corners) {
  Contour contour;
  for (const int turn : sorted_turns(random, corners)) contour.push_back(on_circle(turn, kUnit));
  return contour;
}

Contour star(Random& random, int corners) {
  Contour contour;
  for (const int turn : sorted_turns(random, corners)) {
    const int percent = contour.size() % 2 == 0 ? random.between(70, 100) : random.between(10, 60);
    contour.push_back(on_circle(turn, kUnit / 100 * percent));
  }
  return contour;
}

// A back and three to nine points that stand up from it in turn: the W of seed 1's Fig. 6, and combs.
Contour comb(Random& random) {
  const int points = random.between(3, kMaxCorners - 2);
  Contour contour{{kUnit, kUnit}, {-kUnit, kUnit}};
  for (int i = 0; i < points; ++i) {
    const int y = i % 2 == 0 ? random.between(-kUnit, -kUnit / 2) : random.between(0, kUnit - kUnit / 8);
    contour.push_back({-kUnit + 2 * kUnit * i / (points - 1), y});
  }
  return contour;
}

std::vector<Contour> holed(Random& random) {
  std::vector<Contour> contours{convex(random, random.between(6, kMaxCorners))};
  const int holes = random.between(1, 2);
  for (int i = 0; i < holes; ++i) {
    Contour hole = random.percent(50) ? convex(random, random.between(3, 6)) : star(random, 2 * random.between(2, 4));
    for (Point& p : hole) p = {p.x / 4 + (i == 0 ? -1 : 1) * kUnit * 3 / 10, p.y / 4};
    contours.push_back(hole);
  }
  return contours;
}

// Under a pixel wide, as long as the place allows: three or four corners.
Contour sliver(Random& random, const Place& place) {
  const Point along = circle_point(random.below(1024));
  const int length = std::max(place.radius, 16);
  const Point a{-along.x * length / kUnit, -along.y * length / kUnit};
  const Point b{-a.x + random.between(-8, 8), -a.y + random.between(-8, 8)};
  Contour contour{a, b, {b.x + random.between(-12, 12), b.y + random.between(-12, 12)}};
  if (random.percent(50)) contour.push_back({a.x + random.between(-12, 12), a.y + random.between(-12, 12)});
  for (Point& p : contour) p = {in_16_bits(p.x + place.centre.x), in_16_bits(p.y + place.centre.y)};
  return contour;
}

Contour speck(Random& random, const Place& place) {
  Contour contour;
  const int corners = random.between(3, 5);
  for (const int turn : sorted_turns(random, corners)) {
    const Point p = on_circle(turn, random.between(2, 12));
    contour.push_back({in_16_bits(place.centre.x + p.x), in_16_bits(place.centre.y + p.y)});
  }
  return contour;
}

// Squeezed and sheared at random into the place; an affine map keeps a simple polygon simple up to rounding.
void put_in_place(Random& random, const Place& place, std::vector<Contour>& contours) {
  const Point u = circle_point(random.below(1024));
  const Point v = circle_point(random.below(1024));
  const std::int64_t squeeze = random.percent(30) ? random.between(2, 100) : 100;
  for (Contour& contour : contours) {
    for (Point& p : contour) {
      const std::int64_t x = p.x;
      const std::int64_t y = p.y * squeeze / 100;
      const std::int64_t scale = 2 * std::int64_t{kUnit} * kUnit;  // u and v are units, |x|, |y| <= kUnit
      p = {in_16_bits(place.centre.x + (u.x * x + v.x * y) * place.radius / scale),
           in_16_bits(place.centre.y + (u.y * x + v.y * y) * place.radius / scale)};
    }
  }
}

std::vector<Contour> any_shape(Random& random, const Place& place) {
  std::vector<Contour> contours;
  switch (random.below(12)) {
    case 0:
      return {sliver(random, place)};
    case 1:
      return {speck(random, place)};
    case 2:
    case 3:
    case 4:
      contours = {convex(random, random.between(4, kMaxCorners))};
      break;
    case 5:
    case 6:
      contours = {star(random, random.between(4, kMaxCorners))};
      break;
    case 7:
      contours = {comb(random)};
      break;
    case 8:
      contours = holed(random);
      break;
    default:
      contours = {convex(random, 3)};
      break;
  }
  put_in_place(random, place, contours);
  return contours;
}

int snapped(int value, int snap) {
  const int whole = value >= 0 ? value / snap : -((-value + snap - 1) / snap);
  return whole * snap;
}

}  // namespace

Point circle_point(int turn) {
  const int t = turn & 255;
  const int denominator = 65536 + t * t;
  const int x = (65536 - t * t) * (kUnit / 4) / denominator * 4;
  const int y = 512 * t * (kUnit / 4) / denominator * 4;
  switch (turn >> 8 & 3) {
    case 0:
      return {x, y};
    case 1:
      return {-y, x};
    case 2:
      return {-x, -y};
    default:
      return {y, -x};
  }
}

bool is_simple(const std::vector<Contour>& contours) {
  const std::vector<Side> sides = sides_of(contours);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& a = sides[i];
    if (a.from.x == a.to.x && a.from.y == a.to.y) return false;
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const Side& b = sides[j];
      const bool same_ring = a.contour == b.contour;
      const bool follows = same_ring && j == i + 1;
      const bool closes = same_ring && (i == 0 || sides[i - 1].contour != a.contour) &&
                          (j + 1 == sides.size() || sides[j + 1].contour != a.contour);
      if (follows || closes) {
        if (follows && folds(a.to, a.from, b.to)) return false;
        if (closes && folds(a.from, a.to, b.from)) return false;
      } else if (touch(a.from, a.to, b.from, b.to)) {
        return false;
      }
    }
  }
  return true;
}

std::vector<Contour> random_polygon(Random& random, const Place& place, int snap) {
  constexpr int kAttempts = 6;
  std::vector<Contour> contours;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    contours = any_shape(random, place);
    for (Contour& contour : contours) {
      for (Point& p : contour) p = {snapped(p.x, snap), snapped(p.y, snap)};
    }
    const bool triangle = contours.size() == 1 && contours[0].size() == 3;
    if (triangle || is_simple(contours)) return contours;
  }
  contours.resize(1);
  contours[0].resize(3);
  return contours;
}

}  // namespace spanline::oracle
