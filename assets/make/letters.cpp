#include "extrude.hpp"
#include "shapes.hpp"

namespace spanline::make {

namespace {

constexpr double kHalf = 0.14;
constexpr int kArcSteps = 10;

// Two bowls along one spine, the upper from its right end anticlockwise, the lower clockwise to its left end.
Ring letter_s() {
  constexpr double kRadius = 0.195;
  constexpr double kStroke = 0.105;
  constexpr double kOpening = kPi / 7;
  const Vec upper = {0.31, 0.695, 0};
  const Vec lower = {0.31, 0.305, 0};
  Ring outline;
  arc(outline, upper, kRadius - kStroke, 1.5 * kPi, kOpening, kArcSteps);
  arc(outline, upper, kRadius + kStroke, kOpening, 1.5 * kPi, kArcSteps);
  arc(outline, lower, kRadius - kStroke, kPi / 2, kOpening - kPi, kArcSteps);
  arc(outline, lower, kRadius + kStroke, kOpening - kPi, kPi / 2, kArcSteps);
  return outline;
}

struct Holed {
  Ring outline, hole;
  std::size_t from, to;  // ends of the bridge
};

Holed letter_p() {
  const Vec bowl = {0.33, 0.69, 0};
  Holed p{{{0, 0, 0}, {0.21, 0, 0}, {0.21, 0.38, 0}}, {{0.21, 0.58, 0}, {0.21, 0.8, 0}}, 2, 0};
  arc(p.outline, bowl, 0.31, -kPi / 2, kPi / 2, kArcSteps);
  p.outline.push_back({0, 1, 0});
  arc(p.hole, bowl, 0.11, kPi / 2, -kPi / 2, kArcSteps);
  return p;
}

Holed letter_a() {
  const auto inner = [](double y) { return 0.22 + 0.34 * y; };
  constexpr double kWidth = 0.9;
  constexpr double kBarBottom = 0.2;
  constexpr double kBarTop = 0.37;
  return {{{0, 0, 0},
           {inner(0), 0, 0},
           {inner(kBarBottom), kBarBottom, 0},
           {kWidth - inner(kBarBottom), kBarBottom, 0},
           {kWidth - inner(0), 0, 0},
           {kWidth, 0, 0},
           {0.56, 1, 0},
           {0.34, 1, 0}},
          {{inner(kBarTop), kBarTop, 0}, {kWidth / 2, 0.676, 0}, {kWidth - inner(kBarTop), kBarTop, 0}},
          2,
          0};
}

Ring letter_n() {
  return {{0, 0, 0},    {0.21, 0, 0}, {0.21, 0.6, 0}, {0.55, 0, 0}, {0.76, 0, 0},
          {0.76, 1, 0}, {0.55, 1, 0}, {0.55, 0.4, 0}, {0.21, 1, 0}, {0, 1, 0}};
}

Ring moved(Ring ring, double x) {
  for (Vec& point : ring) point = point + Vec{x, -0.5, 0};
  return ring;
}

void extrude(Mesh& mesh, const Ring& outline) {
  caps(mesh, outline, kHalf);
  walls(mesh, outline, kHalf);
}

void extrude(Mesh& mesh, const Holed& letter, double x) {
  const Ring outline = moved(letter.outline, x);
  const Ring hole = moved(letter.hole, x);
  caps(mesh, bridged(outline, hole, letter.from, letter.to), kHalf);
  walls(mesh, outline, kHalf);
  walls(mesh, hole, kHalf);
}

}  // namespace

Mesh letters() {
  Mesh mesh;
  extrude(mesh, moved(letter_s(), -1.58));
  extrude(mesh, letter_p(), -0.84);
  extrude(mesh, letter_a(), -0.16);
  extrude(mesh, moved(letter_n(), 0.82));
  return mesh;
}

}  // namespace spanline::make
