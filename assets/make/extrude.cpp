#include "extrude.hpp"

namespace spanline::make {

namespace {

// Where two arcs meet, the point that ends one begins the other; an edge of no length has no direction.
Ring without_repeats(const Ring& closed) {
  Ring ring;
  for (const Vec& point : closed) {
    const Vec& before = ring.empty() ? closed.back() : ring.back();
    if (length(point - before) > 1e-9) ring.push_back(point);
  }
  return ring;
}

}  // namespace

void arc(Ring& ring, Vec centre, double radius, double from, double to, int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    ring.push_back(centre + radius * Vec{std::cos(angle), std::sin(angle), 0});
  }
}

void caps(Mesh& mesh, const Ring& ring, double half) {
  std::vector<Mesh::Corner> front;
  std::vector<Mesh::Corner> back;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec& ahead = ring[i];
    const Vec& behind = ring[ring.size() - 1 - i];
    front.push_back({{ahead.x, ahead.y, half}, {0, 0, 1}});
    back.push_back({{behind.x, behind.y, -half}, {0, 0, -1}});
  }
  mesh.face(front);
  mesh.face(back);
}

void walls(Mesh& mesh, const Ring& closed, double half) {
  constexpr double kCreaseCosine = 0.766;  // 40 degrees
  const Ring ring = without_repeats(closed);
  const std::size_t count = ring.size();
  std::vector<Vec> outward;
  outward.reserve(count);
  for (std::size_t i = 0; i < count; ++i) outward.push_back(unit(cross(ring[(i + 1) % count] - ring[i], {0, 0, 1})));
  // The normal of edge `own` at the corner that it shares with edge `other`.
  const auto normal = [&](std::size_t own, std::size_t other) {
    return dot(outward[own], outward[other]) < kCreaseCosine ? outward[own] : unit(outward[own] + outward[other]);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec& p = ring[i];
    const Vec& q = ring[(i + 1) % count];
    const Vec at_p = normal(i, (i + count - 1) % count);
    const Vec at_q = normal(i, (i + 1) % count);
    mesh.face(
        {{{p.x, p.y, -half}, at_p}, {{q.x, q.y, -half}, at_q}, {{q.x, q.y, half}, at_q}, {{p.x, p.y, half}, at_p}});
  }
}

Ring bridged(const Ring& outline, const Ring& hole, std::size_t from, std::size_t to) {
  Ring ring;
  for (std::size_t i = 0; i <= outline.size(); ++i) ring.push_back(outline[(from + i) % outline.size()]);
  for (std::size_t i = 0; i <= hole.size(); ++i) ring.push_back(hole[(to + i) % hole.size()]);
  return ring;
}

}  // namespace spanline::make
