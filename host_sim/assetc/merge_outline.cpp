#include "assetc/merge_outline.hpp"

#include <algorithm>

namespace spanline::host {
void EdgeSet::add(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Edge edge{ring[i], ring[(i + 1) % ring.size()]};
    const auto opposite = edges_.find({edge.second, edge.first});
    if (opposite == edges_.end()) {
      ++edges_[edge];
      continue;
    }
    cancelled_ = true;
    if (--opposite->second == 0) edges_.erase(opposite);
  }
}

// Follows the edges; whenever a vertex comes up again, what lies between is a ring of its own.
std::optional<std::vector<Ring>> EdgeSet::rings() const {
  std::multimap<std::uint16_t, std::uint16_t> next;
  for (const auto& [edge, count] : edges_) {
    if (count > 1) return std::nullopt;
    next.insert(edge);
  }
  std::vector<Ring> rings;
  while (!next.empty()) {
    Ring path = {next.begin()->first};
    while (!path.empty()) {
      const auto edge = next.find(path.back());
      if (edge == next.end()) break;  // the path came back to where it began, and that has become a ring
      const std::uint16_t to = edge->second;
      next.erase(edge);
      const auto before = std::find(path.begin(), path.end(), to);
      if (before == path.end()) {
        path.push_back(to);
        continue;
      }
      rings.emplace_back(before, path.end());
      path.erase(before + 1, path.end());
    }
  }
  return rings;
}

std::optional<std::vector<Ring>> EdgeSet::outline(const std::vector<Position>& positions, GridVector normal) const {
  std::optional<std::vector<Ring>> found = rings();
  if (!found) return std::nullopt;
  const Flattened flat(normal);
  const auto runs_around = [&](const Ring& ring) {
    std::int64_t doubled_area = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      doubled_area += turn(flat(positions[ring[0]]), flat(positions[ring[i]]), flat(positions[ring[i + 1]]));
    }
    return doubled_area > 0;
  };
  if (std::count_if(found->begin(), found->end(), runs_around) != 1) return std::nullopt;
  std::partition(found->begin(), found->end(), runs_around);
  // One outline, holes in it, nothing crosses: the winding number is 1 inside and 0 outside, which even-odd filling
  // agrees to.
  if (!are_simple(*found, positions, normal)) return std::nullopt;
  return found;
}

}  // namespace spanline::host
