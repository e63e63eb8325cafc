#include "shapes.hpp"

namespace spanline::make {

namespace {

// A box with its six sides, or without the ones below and above.
void box(Mesh& mesh, Vec low, Vec high, bool closed) {
  const auto at = [&](int x, int y, int z) {
    return Vec{x != 0 ? high.x : low.x, y != 0 ? high.y : low.y, z != 0 ? high.z : low.z};
  };
  mesh.flat({at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
  mesh.flat({at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0)});
  mesh.flat({at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1)});
  mesh.flat({at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)});
  mesh.flat({at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0)});
  if (closed) mesh.flat({at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)});
}

// A rectangle on the front wall.
void on_front(Mesh& mesh, double left, double right, double low, double high) {
  constexpr double z = 1.5;
  mesh.flat({{left, low, z}, {right, low, z}, {right, high, z}, {left, high, z}});
}

// A rectangle on the gable to the right.
void on_gable(Mesh& mesh, double near, double far, double low, double high) {
  constexpr double x = 2;
  mesh.flat({{x, low, near}, {x, low, far}, {x, high, far}, {x, high, near}});
}

void walls(Mesh& mesh) {
  mesh.material("wall");
  for (const double side : {1.0, -1.0}) {  // front and back, gables to the right and left
    mesh.flat(
        {{-2 * side, 0, 1.5 * side}, {2 * side, 0, 1.5 * side}, {2 * side, 2, 1.5 * side}, {-2 * side, 2, 1.5 * side}});
    mesh.flat({{2 * side, 0, 1.5 * side},
               {2 * side, 0, -1.5 * side},
               {2 * side, 2, -1.5 * side},
               {2 * side, 3.2, 0},
               {2 * side, 2, 1.5 * side}});
  }
}

// A slab that leans from the ridge over one of the long walls.
void roof(Mesh& mesh, double side) {
  constexpr double kLength = 2.4, kThick = 0.12;
  const Vec ridge{0, 3.3, 0}, eaves{0, 1.78, 1.9 * side};
  const auto at = [&](double x, bool low, bool under) {
    const Vec p = low ? eaves : ridge;
    return Vec{x, p.y - (under ? kThick : 0), p.z};
  };
  const double l = -kLength * side, r = kLength * side;
  mesh.flat({at(l, true, false), at(r, true, false), at(r, false, false), at(l, false, false)});
  mesh.flat({at(r, true, true), at(l, true, true), at(l, false, true), at(r, false, true)});
  mesh.flat({at(l, true, true), at(r, true, true), at(r, true, false), at(l, true, false)});
  mesh.flat({at(r, true, true), at(r, false, true), at(r, false, false), at(r, true, false)});
  mesh.flat({at(l, false, true), at(l, true, true), at(l, true, false), at(l, false, false)});
}

void fir(Mesh& mesh, Vec foot) {
  mesh.material("trunk");
  box(mesh, foot + Vec{-0.1, 0, -0.1}, foot + Vec{0.1, 0.5, 0.1}, false);
  mesh.material("leaves");
  constexpr int kSides = 7;
  std::vector<Vec> below;
  const auto rim = [&](int i) {
    const double angle = -2 * kPi * i / kSides;
    return foot + Vec{0.75 * std::cos(angle), 0.5, 0.75 * std::sin(angle)};
  };
  for (int i = 0; i < kSides; ++i) {
    mesh.flat({rim(i), rim(i + 1), foot + Vec{0, 2.6, 0}});
    below.insert(below.begin(), rim(i));
  }
  mesh.flat(below);
}

void windows(Mesh& mesh) {
  mesh.material("frame");
  for (const double x : {-1.25, 1.3}) on_front(mesh, x - 0.42, x + 0.42, 0.72, 1.52);
  on_gable(mesh, 0.5, -0.5, 0.72, 1.52);
  on_front(mesh, -0.4, 0.4, 0, 1.46);
  mesh.material("pane");
  for (const double x : {-1.25, 1.3}) {
    for (const double s : {-1.0, 1.0}) {
      const double from = x + s * 0.04, to = x + s * 0.35;
      on_front(mesh, std::min(from, to), std::max(from, to), 0.79, 1.45);
    }
  }
  on_gable(mesh, 0.43, 0.04, 0.79, 1.45);
  on_gable(mesh, -0.04, -0.43, 0.79, 1.45);
  mesh.material("door");
  on_front(mesh, -0.33, 0.33, 0, 1.39);
}

}  // namespace

Mesh house() {
  Mesh mesh;
  mesh.material("lawn");
  mesh.flat({{-4.6, 0, -3.2}, {-4.6, 0, 3.6}, {4.6, 0, 3.6}, {4.6, 0, -3.2}});
  walls(mesh);
  mesh.material("roof");
  roof(mesh, 1);
  roof(mesh, -1);
  mesh.material("brick");
  box(mesh, {0.9, 2.3, -0.95}, {1.35, 3.75, -0.5}, false);
  fir(mesh, {-3.4, 0, 1.1});
  fir(mesh, {3.5, 0, -1.6});
  windows(mesh);
  mesh.material("path");
  mesh.flat({{-0.4, 0, 1.5}, {-0.4, 0, 3.6}, {0.4, 0, 3.6}, {0.4, 0, 1.5}});
  return mesh;
}

}  // namespace spanline::make
