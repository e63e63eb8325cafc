#include "assetc/merge.hpp"

#include <algorithm>
#include <numeric>

#include "assetc/merge_outline.hpp"
#include "assetc/ring_faces.hpp"

namespace spanline::host {
namespace {

__extension__ using Wide = __int128;

Wide wide_dot(GridVector a, GridVector b) { return Wide{a.x} * b.x + Wide{a.y} * b.y + Wide{a.z} * b.z; }

class Merger {
 public:
  Merger(const MeshTables& mesh, const std::string& place, std::uint32_t most_corners)
      : mesh_(mesh), place_(place), most_corners_(most_corners), faces_(ring_faces(mesh)), home_(faces_.size()) {
    std::iota(home_.begin(), home_.end(), std::size_t{0});
    for (std::size_t i = 0; i < first_detail(); ++i) {
      for_each_edge(faces_[i], [&](std::uint16_t from, std::uint16_t to) { over_.insert({{from, to}, i}); });
    }
  }

  MeshTables run() {
    std::vector<std::size_t> order(faces_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return area(a) > area(b); });
    for (const std::size_t seed : order) {
      if (taken_[seed] || faces_[seed].curved) continue;
      const std::vector<std::size_t> group = grown_from(seed);
      if (join(group)) continue;
      for (const std::size_t face : group) join({face});  // bridges to its own holes
    }
    return tables();
  }

 private:
  template <typename Action>
  static void for_each_edge(const RingFace& face, Action action) {
    for (const Ring& ring : face.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) action(ring[i], ring[(i + 1) % ring.size()]);
    }
  }

  Wide area(std::size_t face) const { return wide_dot(faces_[face].normal, faces_[face].normal); }

  // Whether Gouraud shading, if the scene has it, gives the face one colour: all corners have `normal`.
  bool smooth_with(const RingFace& face, std::uint32_t normal) const {
    if (mesh_.vertex_normals.empty()) return true;
    return std::all_of(face.rings.begin(), face.rings.end(), [&](const Ring& ring) {
      return std::all_of(ring.begin(), ring.end(),
                         [&](std::uint16_t v) { return mesh_.vertex_normals[v].packed == normal; });
    });
  }

  // Every corner is at most one unit off the seed's plane: (n . d)^2 <= n . n.
  bool in_plane_of(const RingFace& seed, const RingFace& face) const {
    const Position& origin = mesh_.positions[seed.rings[0][0]];
    const Wide limit = wide_dot(seed.normal, seed.normal);
    bool near = true;
    for_each_edge(face, [&](std::uint16_t corner, std::uint16_t) {
      const Wide off = wide_dot(seed.normal, mesh_.positions[corner] - origin);
      near = near && off * off <= limit;
    });
    return near;
  }

  std::size_t first_detail() const { return faces_.size() - mesh_.parents.size(); }

  bool belongs(std::size_t seed, std::size_t face) const {
    if (seed >= first_detail()) return false;
    const RingFace& a = faces_[seed];
    const RingFace& b = faces_[face];
    if (b.curved || a.material != b.material || mesh_.face_normals[seed].packed != mesh_.face_normals[face].packed)
      return false;
    if (area(face) == 0 || wide_dot(a.normal, b.normal) <= 0) return false;
    const std::uint32_t normal = mesh_.vertex_normals.empty() ? 0 : mesh_.vertex_normals[a.rings[0][0]].packed;
    return smooth_with(b, normal) && in_plane_of(a, b);
  }

  std::vector<std::size_t> grown_from(std::size_t seed) {
    std::vector<std::size_t> group = {seed};
    taken_[seed] = true;
    if (!belongs(seed, seed)) return group;
    for (std::size_t i = 0; i < group.size(); ++i) {
      for_each_edge(faces_[group[i]], [&](std::uint16_t from, std::uint16_t to) {
        const auto [begin, end] = over_.equal_range({to, from});
        for (auto at = begin; at != end; ++at) {
          if (taken_[at->second] || !belongs(seed, at->second)) continue;
          taken_[at->second] = true;
          group.push_back(at->second);
        }
      });
    }
    return group;
  }

  // Puts the outline of the group in place of its lowest face. False where it cannot be, or nothing would be gained.
  bool join(const std::vector<std::size_t>& group) {
    EdgeSet edges;
    for (const std::size_t face : group) {
      for (const Ring& ring : faces_[face].rings) edges.add(ring);
    }
    const bool small = group.size() == 1 || edges.size() <= most_corners_;
    if (!edges.cancelled_any() || !small) return false;
    std::optional<std::vector<Ring>> rings = edges.outline(mesh_.positions, faces_[group[0]].normal);
    if (!rings) return false;
    const std::size_t home = *std::min_element(group.begin(), group.end());
    for (const std::size_t face : group) {
      faces_[face].rings.clear();
      home_[face] = home;
    }
    faces_[home].rings = std::move(*rings);
    return true;
  }

  std::uint16_t renumbered(std::uint16_t vertex, MeshTables& out) {
    const auto [found, is_new] = numbers_.try_emplace(vertex, static_cast<std::uint16_t>(out.positions.size()));
    if (is_new) {
      out.positions.push_back(mesh_.positions[vertex]);
      if (!mesh_.vertex_normals.empty()) out.vertex_normals.push_back(mesh_.vertex_normals[vertex]);
    }
    return found->second;
  }

  MeshTables tables() {
    MeshTables out;
    out.name = mesh_.name;
    out.unit = mesh_.unit;
    std::copy(std::begin(mesh_.origin), std::end(mesh_.origin), out.origin);
    std::vector<std::uint16_t> now(faces_.size());  // the numbers of those that are left
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::vector<Ring>& rings = faces_[i].rings;
      if (rings.empty()) continue;
      now[i] = out.face_count;
      std::vector<Ring> renamed = rings;
      for (Ring& ring : renamed) {
        for (std::uint16_t& vertex : ring) vertex = renumbered(vertex, out);
      }
      append_rings(out, renamed, faces_[i].material, faces_[i].curved, place_);
      out.face_normals.push_back(mesh_.face_normals[i]);
    }
    for (CurveRecord curve : mesh_.curves) {
      const std::uint32_t old = curve.first_corner;
      curve.first_corner = static_cast<std::uint32_t>(out.corners.size());
      for (std::uint32_t i = 0; i < curve.point_count; ++i) {
        out.corners.push_back(renumbered(mesh_.corners[old + i], out));
      }
      out.curves.push_back(curve);
    }
    for (const std::uint16_t parent : mesh_.parents) out.parents.push_back(now[home_[parent]]);
    return out;
  }

  const MeshTables& mesh_;
  const std::string& place_;
  const std::uint32_t most_corners_;
  std::vector<RingFace> faces_;
  std::vector<std::size_t> home_;                                             // the face that each has become part of
  std::multimap<std::pair<std::uint16_t, std::uint16_t>, std::size_t> over_;  // directed edge to the faces that have it
  std::vector<bool> taken_ = std::vector<bool>(faces_.size());
  std::map<std::uint16_t, std::uint16_t> numbers_;
};

}  // namespace

MeshTables merge_coplanar(const MeshTables& mesh, const std::string& place, std::uint32_t most_corners) {
  return mesh.face_normals.empty() ? mesh : Merger(mesh, place, most_corners).run();
}

}  // namespace spanline::host
