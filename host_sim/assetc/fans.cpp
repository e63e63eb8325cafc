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

// An edge as its vertex has it; `before`: the face clockwise of it.
struct Spoke {
  Number to, face, before;
};

// The spokes of a vertex, counter-clockwise.
std::vector<FanEdge> round_of(Number vertex, std::vector<Spoke> spokes) {
  // Open rounds begin where there is no face before.
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
    return std::tuple(a.before != FanEdge::kNone, a.face) < std::tuple(b.before != FanEdge::kNone, b.face);
  });
  std::vector<std::vector<FanEdge>> rounds;
  while (!spokes.empty()) {
    const Number before = spokes.front().before;
    std::vector<FanEdge>& round = rounds.emplace_back();
    for (auto next = spokes.begin(); next != spokes.end() && (round.empty() || round.back().face != before);) {
      round.push_back({next->to, next->face});
      spokes.erase(next);
      next = std::find_if(spokes.begin(), spokes.end(), [&](const Spoke& s) { return s.before == round.back().face; });
    }
  }
  std::vector<FanEdge> fan;
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    const std::vector<FanEdge>& last = i == 0 ? rounds.back() : rounds[i - 1];
    if (last.back().face != rounds[i].back().face) fan.push_back({vertex, rounds[i].back().face});
    fan.insert(fan.end(), rounds[i].begin(), rounds[i].end());
  }
  return fan;
}

}  // namespace

void build_fans(MeshTables& mesh) {
  constexpr std::size_t kMost = 65535;
  mesh.fan_starts.clear();
  mesh.fans.clear();
  if (!only_triangles(mesh) || mesh.face_count > FanEdge::kMostFaces) return;
  std::vector<std::vector<Spoke>> around(mesh.positions.size());
  for (const Edge& edge : pair_edges(mesh)) {
    around[edge.from].push_back({edge.to, edge.face, edge.twin});
    around[edge.to].push_back({edge.from, edge.twin, edge.face});
  }
  std::vector<FanEdge> fans;
  std::vector<Number> starts{0};
  for (std::size_t v = 0; v < around.size(); ++v) {
    if (around[v].size() > FanEdge::kMostInFan / 2) return;  // there may be an entry more for each two of them
    const std::vector<FanEdge> fan = round_of(static_cast<Number>(v), std::move(around[v]));
    fans.insert(fans.end(), fan.begin(), fan.end());
    if (fans.size() > kMost) return;
    starts.push_back(static_cast<Number>(fans.size()));
  }
  mesh.fan_starts = std::move(starts);
  mesh.fans = std::move(fans);
}

}  // namespace spanline::host
