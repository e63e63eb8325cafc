// The outline of a set of polygons in one plane, as simple rings.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "assetc/ring_faces.hpp"

namespace spanline::host {

// Directed edges; an edge and its opposite cancel each other.
class EdgeSet {
 public:
  void add(const Ring& ring);
  bool cancelled_any() const { return cancelled_; }
  std::size_t size() const { return edges_.size(); }  // without repetitions

  // The edges that are left as rings that pass no vertex twice, the outline first. Nothing where they are not one
  // simple outline and its holes, seen along `normal`.
  std::optional<std::vector<Ring>> outline(const std::vector<Position>& positions, GridVector normal) const;

 private:
  using Edge = std::pair<std::uint16_t, std::uint16_t>;
  std::optional<std::vector<Ring>> rings() const;
  std::map<Edge, int> edges_;
  bool cancelled_ = false;
};

}  // namespace spanline::host
