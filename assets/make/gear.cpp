#include "extrude.hpp"
#include "lathe.hpp"
#include "shapes.hpp"

namespace spanline::make {

namespace {

constexpr double kModule = 0.1;  // pitch diameter by tooth

// One tooth of straight flanks (a rack's 20 degrees), from the middle of the gap before it, gap after it not included.
void tooth(Ring& ring, double pitch, double middle, double half_step) {
  const double root = pitch - 1.25 * kModule;
  const double tip = pitch + kModule;
  const auto flank = [&](double radius, double half_width) {
    ring.push_back(polar(radius, middle + half_width / radius));
  };
  ring.push_back(polar(root, middle - half_step));
  flank(root, -0.104);
  flank(pitch, -0.075);
  flank(tip, -0.04);
  flank(tip, 0.04);
  flank(pitch, 0.075);
  flank(root, 0.104);
}

struct Web {
  double bore, hole_at, hole_radius;
};

// The web's face between two neighbouring holes: round the gear outside, back along half of either hole and the bore.
Ring sector(const Ring& outline, std::size_t begin, std::size_t end, const Web& web, double from, double to) {
  constexpr int kHoleSteps = 10;
  constexpr int kBoreSteps = 8;
  Ring ring;
  arc(ring, polar(web.hole_at, from), web.hole_radius, from + kPi, from, kHoleSteps);
  for (std::size_t i = begin; i <= end; ++i) ring.push_back(outline[i % outline.size()]);
  arc(ring, polar(web.hole_at, to), web.hole_radius, to, to - kPi, kHoleSteps);
  arc(ring, {}, web.bore, to, from, kBoreSteps);
  return ring;
}

Ring circle(Vec centre, double radius, double start, int steps) {
  Ring ring;
  arc(ring, centre, radius, start, start - 2 * kPi, steps);
  ring.pop_back();
  return ring;
}

// Conical on both sides of the web, so that it takes the light differently from the flat faces.
void hub(Mesh& mesh, double bore, double foot, double top, double web_half, double half) {
  constexpr int kSteps = 24;
  lathe(mesh, {{bore, -half}, {top, -half}, {foot, -web_half}, {foot, web_half}, {top, half}, {bore, half}}, kSteps);
}

}  // namespace

Mesh gear(int teeth, int holes) {
  constexpr double kHalf = 0.12;
  const double pitch = teeth * kModule / 2;
  const double half_step = kPi / teeth;
  Ring outline;
  for (int i = 0; i < teeth; ++i) tooth(outline, pitch, (2 * i + 1) * half_step, half_step);

  const Web web = {0.24 * pitch, 0.56 * pitch, 0.15 * pitch};
  const std::size_t points_a_sector = outline.size() / static_cast<std::size_t>(holes);
  Mesh mesh;
  walls(mesh, outline, kHalf);
  for (int i = 0; i < holes; ++i) {
    const double from = 2 * kPi * i / holes;
    const double to = 2 * kPi * (i + 1) / holes;
    const auto begin = static_cast<std::size_t>(i) * points_a_sector;
    caps(mesh, sector(outline, begin, begin + points_a_sector, web, from, to), kHalf);
    walls(mesh, circle(polar(web.hole_at, from), web.hole_radius, from, 20), kHalf);
  }
  walls(mesh, circle({}, web.bore, 0, 8 * holes), kHalf);
  hub(mesh, 0.14 * pitch, 0.36 * pitch, 0.22 * pitch, 0.8 * kHalf, 2.2 * kHalf);
  return mesh;
}

}  // namespace spanline::make
