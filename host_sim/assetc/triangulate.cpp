#include "assetc/triangulate.hpp"

#include <array>
#include <numeric>

#include "assetc/fans.hpp"
#include "assetc/ring_faces.hpp"

namespace spanline::host {
namespace {

using Triangle = std::array<std::uint16_t, 3>;

// Cuts one face. Its ring may touch itself, along bridges for one, but never crosses itself.
class EarClipper {
 public:
  EarClipper(const RingFace& face, const std::vector<Position>& positions)
      : positions_(positions), flat_(face.normal), ring_(face.rings.front()) {
    for (std::size_t i = 1; i < face.rings.size(); ++i) holes_.push_back(face.rings[i]);
  }

  std::optional<std::vector<Triangle>> run() {
    while (!holes_.empty()) {
      if (!bridge_one()) return std::nullopt;
    }
    while (ring_.size() > 3) {
      if (!clip_shortest()) return std::nullopt;
    }
    clipped_.push_back({ring_[0], ring_[1], ring_[2]});
    return std::move(clipped_);
  }

 private:
  GridPoint at(std::uint16_t vertex) const { return flat_(positions_[vertex]); }
  std::uint16_t corner(std::size_t i) const { return ring_[i % ring_.size()]; }
  std::uint16_t before(std::size_t i) const { return corner(i + ring_.size() - 1); }

  std::int64_t distance(std::uint16_t a, std::uint16_t b) const {
    const GridVector d = positions_[a] - positions_[b];
    return d.x * d.x + d.y * d.y + d.z * d.z;
  }

  // Whether what leaves the ring's corner `i` for `p` sets out into the face (O'Rourke 1998, 1.6.2).
  bool in_cone(std::size_t i, GridPoint p) const {
    const GridPoint own = at(corner(i)), next = at(corner(i + 1)), last = at(before(i));
    if (turn(last, own, next) > 0) return turn(own, p, last) > 0 && turn(own, next, p) > 0;
    return !(turn(own, p, next) >= 0 && turn(own, last, p) >= 0);
  }

  bool meets(const Ring& ring, const GridSegment& segment) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const GridPoint from = at(ring[i]), to = at(ring[(i + 1) % ring.size()]);
      if (collide(segment, {from, to}) || collide(segment, {to, from})) return true;
    }
    return false;
  }
  bool free(std::uint16_t a, std::uint16_t b) const {
    const GridSegment segment{at(a), at(b)};
    if (segment.from == segment.to || meets(ring_, segment)) return false;
    return std::none_of(holes_.begin(), holes_.end(), [&](const Ring& hole) { return meets(hole, segment); });
  }

  // Cuts the face open from its outline to the hole that is nearest, along the shortest way that is free.
  bool bridge_one() {
    struct Way {
      std::int64_t length;
      std::size_t hole, from, corner;
    };
    std::vector<Way> ways;
    for (std::size_t hole = 0; hole < holes_.size(); ++hole) {
      for (std::size_t from = 0; from < holes_[hole].size(); ++from) {
        for (std::size_t i = 0; i < ring_.size(); ++i) {
          ways.push_back({distance(holes_[hole][from], ring_[i]), hole, from, i});
        }
      }
    }
    std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.length < b.length; });
    for (const Way& way : ways) {
      Ring& hole = holes_[way.hole];
      if (!free(ring_[way.corner], hole[way.from]) || !in_cone(way.corner, at(hole[way.from]))) continue;
      std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(way.from), hole.end());
      hole.push_back(hole.front());
      hole.push_back(ring_[way.corner]);
      ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(way.corner) + 1, hole.begin(), hole.end());
      holes_.erase(holes_.begin() + static_cast<std::ptrdiff_t>(way.hole));
      return true;
    }
    return false;
  }

  // The corner before `i` and the one behind it see each other through the face, and `i` sticks out.
  bool is_ear(std::size_t i) const {
    const std::size_t last = (i + ring_.size() - 1) % ring_.size(), next = (i + 1) % ring_.size();
    const std::uint16_t a = ring_[last], c = ring_[next];
    return turn(at(a), at(ring_[i]), at(c)) > 0 && in_cone(last, at(c)) && in_cone(next, at(a)) && free(a, c);
  }

  bool clip_shortest() {
    std::vector<std::size_t> order(ring_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto diagonal = [&](std::size_t i) { return distance(before(i), corner(i + 1)); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return diagonal(i) < diagonal(j); });
    const auto ear = std::find_if(order.begin(), order.end(), [&](std::size_t i) { return is_ear(i); });
    if (ear == order.end()) return false;
    clipped_.push_back({before(*ear), ring_[*ear], corner(*ear + 1)});
    ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(*ear));
    return true;
  }

  const std::vector<Position>& positions_;
  Flattened flat_;
  Ring ring_;
  std::vector<Ring> holes_;
  std::vector<Triangle> clipped_;
};

// Without area nothing is ever drawn of a face, however it is cut.
std::vector<Triangle> fan_of(const Ring& ring) {
  std::vector<Triangle> fan;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) fan.push_back({ring[0], ring[i], ring[i + 1]});
  return fan;
}

std::optional<std::vector<Triangle>> cut(const RingFace& face, const std::vector<Position>& positions) {
  std::size_t corners = 0;
  for (const Ring& ring : face.rings) corners += ring.size();
  if (face.curved || corners > kMostCutCorners) return std::nullopt;
  const GridVector n = face.normal;
  const bool has_area = n.x != 0 || n.y != 0 || n.z != 0;
  if (corners == 3 || (!has_area && face.rings.size() == 1)) return fan_of(face.rings.front());
  if (!has_area || !are_simple(face.rings, positions, face.normal)) return std::nullopt;
  return EarClipper(face, positions).run();
}

// All that is not of faces.
MeshTables without_faces(const MeshTables& mesh) {
  MeshTables out = mesh;
  out.corners.clear();
  out.contours.clear();
  out.groups.clear();
  out.face_normals.clear();
  out.face_count = 0;
  out.curves.clear();
  return out;
}

}  // namespace

std::optional<MeshTables> triangulate(const MeshTables& mesh, const std::string& place) {
  if (mesh.face_normals.empty() || !mesh.parents.empty()) return std::nullopt;
  const std::vector<RingFace> faces = ring_faces(mesh);
  MeshTables out = without_faces(mesh);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::optional<std::vector<Triangle>> triangles = cut(faces[i], mesh.positions);
    if (!triangles) return std::nullopt;
    for (const Triangle& triangle : *triangles) {
      append_rings(out, {Ring(triangle.begin(), triangle.end())}, faces[i].material, false, place);
      out.face_normals.push_back(mesh.face_normals[i]);
    }
  }
  for (CurveRecord curve : mesh.curves) {
    const auto points = mesh.corners.begin() + static_cast<std::ptrdiff_t>(curve.first_corner);
    curve.first_corner = static_cast<std::uint32_t>(out.corners.size());
    out.corners.insert(out.corners.end(), points, points + curve.point_count);
    out.curves.push_back(curve);
  }
  build_fans(out);
  return out;
}

}  // namespace spanline::host
