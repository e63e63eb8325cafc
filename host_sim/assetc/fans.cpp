#include "assetc/fans.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace spanline::host {
namespace {

using Number = std::uint16_t;

bool only_triangles(const MeshTables& mesh) {
  return std::all_of(mesh.groups.begin(), mesh.groups.end(),
                     [](const FaceGroup& group) { return group.corners_per_face == 3 && group.contour_count == 1; });
}

// An edge with the face that runs from `from` to `to` and the one that runs back.
struct Edge {
  Number from, to, face, twin;
};

bool is_degenerate(const Number* corner) {
  return corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0];
}

// Where a half-edge finds another one, unpaired and opposite, they become one edge.
std::vector<Edge> pair_edges(const MeshTables& mesh) {
  std::vector<Edge> edges;
  std::multimap<std::pair<Number, Number>, std::size_t> unpaired;
  for (const FaceGroup& group : mesh.groups) {
    for (std::size_t i = 0; i < group.face_count; ++i) {
      const auto face = static_cast<Number>(group.first_face + i);
      const Number* corner = mesh.corners.data() + group.first_corner + 3 * i;
      if (is_degenerate(corner)) continue;  // never drawn
      for (std::size_t k = 0; k < 3; ++k) {
        const Number from = corner[k], to = corner[(k + 1) % 3];
        const auto found = unpaired.find({to, from});
        if (found == unpaired.end()) {
          unpaired.emplace(std::pair{from, to}, edges.size());
          edges.push_back({from, to, face, FanEdge::kNone});
        } else {
          edges[found->second].twin = face;
          unpaired.erase(found);
        }
      }
    }
  }
  return edges;
}

}  // namespace

void build_fans(MeshTables& mesh) {
  constexpr std::size_t kMost = 65535;
  mesh.fan_starts.clear();
  mesh.fans.clear();
  if (!only_triangles(mesh)) return;
  const std::vector<Edge> edges = pair_edges(mesh);
  if (2 * edges.size() > kMost) return;
  std::vector<std::vector<FanEdge>> around(mesh.positions.size());
  for (const Edge& edge : edges) {
    around[edge.from].push_back({edge.to, edge.face, edge.twin});
    around[edge.to].push_back({edge.from, edge.twin, edge.face});
  }
  mesh.fan_starts.push_back(0);
  for (std::vector<FanEdge>& fan : around) {
    std::sort(fan.begin(), fan.end(),
              [](const FanEdge& a, const FanEdge& b) { return std::tie(a.face, a.twin) < std::tie(b.face, b.twin); });
    mesh.fans.insert(mesh.fans.end(), fan.begin(), fan.end());
    mesh.fan_starts.push_back(static_cast<Number>(mesh.fans.size()));
  }
}

}  // namespace spanline::host
