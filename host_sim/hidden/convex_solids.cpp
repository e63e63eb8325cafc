#include "hidden/convex_solids.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "assetc/vec.hpp"

namespace spanline::host {
namespace {

constexpr double kRounding = 2;  // units of a position

Vec3 vec(const Position& p) { return {double{1} * p.x, double{1} * p.y, double{1} * p.z}; }

std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

// The connected faces of each number, which is the first of them.
std::map<std::size_t, std::vector<std::size_t>> components(const std::vector<SolidFace>& faces) {
  std::vector<std::size_t> parent(faces.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  std::map<std::array<std::int64_t, 4>, std::size_t> corner_of;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const Position& p : faces[i].corners) {
      const auto [known, fresh] = corner_of.try_emplace({faces[i].instance, p.x, p.y, p.z}, i);
      if (!fresh) parent[root_of(parent, i)] = root_of(parent, known->second);
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> all;
  for (std::size_t i = 0; i < faces.size(); ++i) all[root_of(parent, i)].push_back(i);
  return all;
}

Vec3 normal_of(const SolidFace& face) {
  Vec3 normal;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    normal = normal + cross(vec(face.corners[i]), vec(face.corners[(i + 1) % face.corners.size()]));
  }
  return unit_or(normal, {});
}

bool is_convex(const std::vector<SolidFace>& faces, const std::vector<std::size_t>& members) {
  for (const std::size_t face : members) {
    const Vec3 normal = normal_of(faces[face]), origin = vec(faces[face].corners[0]);
    for (const std::size_t other : members) {
      for (const Position& p : faces[other].corners) {
        if (dot(normal, vec(p) - origin) > kRounding) return false;
      }
    }
  }
  return true;
}

}  // namespace

std::vector<std::int32_t> convex_solids(const std::vector<SolidFace>& faces) {
  std::vector<std::int32_t> solid(faces.size(), kNoSolid);
  std::int32_t count = 0;
  for (const auto& [first, members] : components(faces)) {
    if (members.size() < 2 || !is_convex(faces, members)) continue;
    for (const std::size_t face : members) solid[face] = count;
    ++count;
  }
  return solid;
}

}  // namespace spanline::host
