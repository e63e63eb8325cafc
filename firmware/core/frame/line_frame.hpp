// A frame of lines: a scene's visible edges, each once, as a plotter or an electronic paper shows them. Hidden surfaces
// go by the area sort (seed 2) on the board itself; the lines, one pixel wide, lie in a picture of one bit a pixel
// until they are sent. Faces are plane; detail is drawn; see-through faces and their detail hide nothing.
#pragma once

#include "core/area/line_drawing.hpp"
#include "core/area/window_sort.hpp"
#include "core/frame/frame.hpp"
#include "core/frame/storage.hpp"
#include "core/geom/facet.hpp"

namespace spanline {

// The pools, erased.
struct LineStorage {
  Screen screen;
  PoolRef<ScreenPoint> vertices;
  PoolRef<area::Box> bounds;  // of every face of the scene
  area::SortPools sort;
  PoolRef<std::uint16_t> names;  // of faces in a window and those around it: about twice the faces
  PoolRef<area::DrawnEdge> edges;
  PoolRef<area::GridPoint> corners;
  PoolRef<std::uint8_t> bits;  // of the picture, line by line, each line from a whole byte on
};

constexpr std::uint32_t bits_of_lines(const Screen& screen) {
  return bytes_per_line(PixelFormat::mono1, screen.width) * screen.height;
}

// Stands in for a Frame: see there.
class LineFrame {
 public:
  explicit LineFrame(const LineStorage& storage);
  LineFrame(const LineFrame&) = delete;
  LineFrame& operator=(const LineFrame&) = delete;

  // The whole picture is drawn when its first line is asked for. The picture lacks what the status tells of:
  // bad_argument ("camera"), or pool_exhausted with the pool's name (index: the face that asked for more), and then it
  // has no lines.
  Band prepare(const SceneView& scene, const CameraRecord& camera, Band rest);
  bool next_line(Slice<std::uint8_t> out);
  std::uint32_t line_bytes() const { return painter_.line_bytes(); }
  void redraw(Band) {}  // every line is drawn in every frame
  const Status& status() const { return status_; }

 private:
  // What LineDrawing and the area sort hand out, and how one asks the other for faces.
  struct Faces;
  struct Pieces;
  struct Pen;

  Status find_lines(const SceneView& scene, const CameraRecord& camera);

  LineStorage storage_;
  area::AreaSort sort_;
  area::LineDrawing drawing_;
  Painter painter_;
  std::uint16_t ink_ = 0;  // payload
  Band band_;
  Status status_;
};

// Its pools: of a Budget's, `facets` is the scene's faces, `polygons` those of a window, `edges` and `segments` their
// borders' edges and pieces; `lines` the edges of all that is visible.
template <Budget kBudget>
class LineMemory {
 public:
  LineStorage storage() {
    return {{kBudget.width, kBudget.height, kBudget.format},
            vertices_.ref(),
            bounds_.ref(),
            sort_.refs(),
            names_.ref(),
            edges_.ref(),
            corners_.ref(),
            bits_.ref()};
  }

 private:
  Pool<ScreenPoint, kBudget.vertices> vertices_;
  Pool<area::Box, kBudget.facets> bounds_;
  area::SortStorage<kBudget.polygons, kBudget.edges, kBudget.segments, 1> sort_;
  Pool<std::uint16_t, 2 * kBudget.facets> names_;
  Pool<area::DrawnEdge, kBudget.lines> edges_;
  Pool<area::GridPoint, kBudget.lines> corners_;
  Pool<std::uint8_t, bits_of_lines({kBudget.width, kBudget.height, kBudget.format})> bits_;
};

// What draws a budget's picture, and its memory.
template <Budget kBudget>
using FrameFor = std::conditional_t<kBudget.lines != 0, LineFrame, Frame<options_for(kBudget)>>;
template <Budget kBudget>
using MemoryFor = std::conditional_t<kBudget.lines != 0, LineMemory<kBudget>, FrameMemory<kBudget>>;

}  // namespace spanline
