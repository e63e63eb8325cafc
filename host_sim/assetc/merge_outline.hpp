// The outline of a set of polygons in one plane, as simple rings.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/scene/format.hpp"

namespace spanline::host {

// In units of the grid. Areas of 16-bit positions fit 64 bits; products of areas do not.
struct GridVector {
  std::int64_t x = 0, y = 0, z = 0;

  friend GridVector operator+(GridVector a, GridVector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
};

inline GridVector operator-(const Position& a, const Position& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline GridVector cross(GridVector a, GridVector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Ring = std::vector<std::uint16_t>;  // vertex numbers, closed by itself

// Twice the area of a ring as a vector (Newell), towards the side from which it runs counter-clockwise.
GridVector newell(const Ring& ring, const std::vector<Position>& positions);

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
