#include "core/vsg/edge_table.hpp"

namespace spanline {

namespace {

bool same_end(const FacetVertex& a, const FacetVertex& b) {
  return a.at == b.at && a.depth == b.depth && a.color == b.color;
}

}  // namespace

bool EdgeTable::add(const ScreenEdge& edge, std::uint16_t polygon) {
  const std::int32_t line = edge.first_line();
  std::uint16_t before = 0, at = first_;
  while (at != 0 && blocks_[at].edge.first_line() < line) {
    before = at;
    at = blocks_[at].next;
  }
  for (std::uint16_t twin = at; twin != 0 && blocks_[twin].edge.first_line() == line; twin = blocks_[twin].next) {
    EdgeBlock& block = blocks_[twin];
    if (block.polygons[1] == 0 && same_end(block.edge.top, edge.top) && same_end(block.edge.bottom, edge.bottom)) {
      block.polygons[1] = polygon;
      return true;
    }
  }
  const std::uint16_t index = blocks_.take();
  if (index == 0) return false;
  blocks_[index] = {at, {polygon, 0}, edge};
  (before == 0 ? first_ : blocks_[before].next) = index;
  return true;
}

std::uint16_t EdgeTable::pop(std::int32_t line) {
  const std::uint16_t index = first_;
  if (index == 0 || blocks_[index].edge.first_line() > line) return 0;
  first_ = blocks_[index].next;
  return index;
}

bool EdgeTable::enters(std::uint16_t polygon, std::int32_t line) const {
  for (std::uint16_t at = first_; at != 0 && blocks_[at].edge.first_line() <= line; at = blocks_[at].next) {
    if (blocks_[at].polygons[0] == polygon || blocks_[at].polygons[1] == polygon) return true;
  }
  return false;
}

void EdgeTable::forget(std::uint16_t polygon) {
  std::uint16_t* link = &first_;
  while (*link != 0) {
    const std::uint16_t index = *link;
    EdgeBlock& block = blocks_[index];
    if (block.polygons[1] == polygon) block.polygons[1] = 0;
    if (block.polygons[0] == polygon) {
      block.polygons[0] = block.polygons[1];
      block.polygons[1] = 0;
    }
    if (block.polygons[0] == 0) {
      *link = block.next;
      blocks_.give(index);
    } else {
      link = &block.next;
    }
  }
}

}  // namespace spanline
