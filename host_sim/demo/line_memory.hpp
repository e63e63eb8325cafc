// A LineMemory whose sizes are chosen at run time. The lines depend on them: where a window does not fit, it is
// quartered, and edges are cut at its sides to the nearest 1/16 px.
#pragma once

#include <vector>

#include "core/frame/line_frame.hpp"

namespace spanline::host {

class HostLineMemory {
 public:
  HostLineMemory(const Screen& screen, const Budget& budget)
      : screen_(screen),
        vertices_(budget.vertices),
        bounds_(budget.facets),
        polygons_(budget.polygons),
        borders_(budget.edges),
        pieces_(budget.segments),
        films_(1),
        frames_(budget.polygons + 1u),
        segments_(budget.edges),
        nodes_(budget.edges),
        edges_(budget.edges),
        contours_(budget.segments),
        names_(2u * budget.facets),
        drawn_(budget.lines),
        corners_(budget.lines),
        bits_(bits_of_lines(screen)) {}

  LineStorage storage() {
    return {screen_,
            vertices_.ref(),
            bounds_.ref(),
            {polygons_.ref(),
             borders_.ref(),
             pieces_.ref(),
             films_.ref(),
             frames_.ref(),
             {segments_.ref(), nodes_.ref(), edges_.ref(), contours_.ref()}},
            names_.ref(),
            drawn_.ref(),
            corners_.ref(),
            bits_.ref()};
  }

 private:
  // The blocks and their sink.
  template <typename T>
  class Blocks {
   public:
    explicit Blocks(std::size_t capacity) : items_(capacity + 1) {}
    PoolRef<T> ref() { return {items_.data(), static_cast<std::uint16_t>(items_.size() - 1)}; }

   private:
    std::vector<T> items_;
  };

  Screen screen_;
  Blocks<ScreenPoint> vertices_;
  Blocks<area::Box> bounds_;
  Blocks<area::NamedPolygon> polygons_;
  Blocks<area::BorderEdge> borders_;
  Blocks<area::Piece> pieces_;
  Blocks<area::Film> films_;
  Blocks<area::SortFrame> frames_;
  Blocks<area::Segment> segments_;
  Blocks<area::Node> nodes_;
  Blocks<area::Edge> edges_;
  Blocks<area::Contour> contours_;
  Blocks<std::uint16_t> names_;
  Blocks<area::DrawnEdge> drawn_;
  Blocks<area::GridPoint> corners_;
  Blocks<std::uint8_t> bits_;
};

}  // namespace spanline::host
