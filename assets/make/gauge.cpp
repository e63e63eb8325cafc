#include "extrude.hpp"
#include "lathe.hpp"
#include "shapes.hpp"

namespace spanline::make {

namespace {

constexpr int kSteps = 32;        // of a full circle
constexpr double kInside = 0.88;  // radius of the dial
constexpr double kDialZ = -0.1;
constexpr double kMarkZ = kDialZ + 0.01;  // zones and ticks lie on the dial
constexpr double kReach = 0.75 * kPi;     // of the scale to either side

// 0 … 1 along the scale, clockwise, to an angle from the x axis.
double angle_at(double along) { return kPi / 2 + kReach - 2 * kReach * along; }

// A part of a ring between two angles, counter-clockwise.
void sector(Mesh& mesh, double inner, double outer, double from, double to, int steps, double z) {
  Ring ring;
  arc(ring, {0, 0, z}, outer, from, to, steps);
  arc(ring, {0, 0, z}, inner, to, from, steps);
  mesh.flat(ring);
}

void tick(Mesh& mesh, double along, double inner, double outer, double half_width) {
  const double angle = angle_at(along);
  const Vec out = polar(1, angle), aside = half_width * polar(1, angle + kPi / 2), up = {0, 0, kMarkZ};
  mesh.flat({inner * out - aside + up, outer * out - aside + up, outer * out + aside + up, inner * out + aside + up});
}

}  // namespace

Mesh gauge_rim() {
  Mesh mesh;
  lathe(mesh, {{1, kDialZ}, {0.97, 0.05}, {0.91, 0.05}, {kInside, kDialZ}}, kSteps);
  return mesh;
}

Mesh gauge_dial() {
  Mesh mesh;
  Ring disc;
  arc(disc, {0, 0, kDialZ}, kInside, 0, 2 * kPi, kSteps);
  disc.pop_back();
  mesh.flat(disc);
  return mesh;
}

Mesh gauge_scale() {
  Mesh mesh;
  const auto zone = [&](const char* material, double from, double to, int steps) {
    mesh.material(material);
    sector(mesh, 0.76, 0.83, angle_at(to), angle_at(from), steps, kMarkZ);
  };
  zone("low", 0, 0.2, 6);
  zone("good", 0.2, 0.8, 18);
  zone("high", 0.8, 1, 6);
  mesh.material("tick");
  constexpr int kMajor = 10, kMinor = 2;  // minor steps in a major one
  for (int i = 0; i <= kMajor * kMinor; ++i) {
    const bool major = i % kMinor == 0;
    tick(mesh, static_cast<double>(i) / (kMajor * kMinor), major ? 0.56 : 0.64, 0.72, major ? 0.022 : 0.012);
  }
  return mesh;
}

// A ridge along the middle gives it a light and a dark side.
Mesh gauge_needle() {
  constexpr double kTail = -0.2, kTip = 0.68, kHalf = 0.06, kBase = -0.06, kRidge = 0;
  Mesh mesh;
  const Vec tail = {0, kTail, kBase}, tip = {0, kTip, kBase}, left = {-kHalf, 0, kBase}, right = {kHalf, 0, kBase};
  const Vec top = {0, 0, kRidge};
  mesh.flat({left, top, tip});
  mesh.flat({top, right, tip});
  mesh.flat({tail, top, left});
  mesh.flat({tail, right, top});
  mesh.flat({left, tip, right, tail});
  constexpr int kCapSteps = 12;
  lathe(mesh, {{0.12, kBase}, {0.12, 0.02}, {0.06, 0.05}, {0, 0.05}, {0, kBase}}, kCapSteps);
  return mesh;
}

}  // namespace spanline::make
