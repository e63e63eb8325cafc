// The band curve plotter: all curves of a scene, drawn line by line without a frame buffer.
#pragma once

#include <cstdint>

#include "core/base/pool.hpp"
#include "core/base/status.hpp"
#include "core/curve/curve_reader.hpp"
#include "core/curve/line_coverage.hpp"
#include "core/curve/stroke.hpp"

namespace spanline {

// A piece of a curve that waits for its first line in a Y-bucket.
struct WaitingPiece {
  std::uint16_t next;
  std::uint16_t curve, piece;
};

// A strand that has begun or will; it keeps its place while lines, and bands, pass.
struct StrandBlock {
  std::uint16_t next;
  std::uint16_t curve;
  std::int16_t first_line;
  Rgb8 color;
  Stroke stroke;
};
static_assert(sizeof(StrandBlock) <= 112);  // 96 of them its walk: four 64-bit differences in x and in y, and its place

// The pools, erased.
struct CurveStorage {
  PoolRef<WaitingPiece> pieces;
  PoolRef<std::uint16_t> buckets;  // one a line; its capacity is the longest run of lines that is planned
  PoolRef<StrandBlock> strands;
  PoolRef<CoverageMask> masks;  // one a column
};

// Curves wait for their first line by the piece, in buckets; a piece whose line has come is cut into strands, and these
// are walked as the lines come. Only strands that are alive hold a walk.
class CurvePlotter {
 public:
  CurvePlotter() = default;
  CurvePlotter(const CurvePlotter&) = delete;
  CurvePlotter& operator=(const CurvePlotter&) = delete;

  // Before all else: the pools to work in, then the screen; masks there are as many as columns at least.
  void use(const CurveStorage& storage) { storage_ = storage; }
  void open(const Screen& screen);

  // What comes next lies on lines [top, bottom). Where it follows the line drawn last, of the same scene and camera,
  // strands that are alive go on; otherwise those that began above begin again from their upper ends, and the picture
  // is the same. A frame begins with line 0, and forgets the status. What the scene's records point to must stay.
  void begin(const SceneView& scene, const CameraRecord& camera, std::int32_t top, std::int32_t bottom);

  // Draws the curves of `line`, the next one, in the order of their numbers: for each curve
  // paint(Rgb8, LineCoverage&), which takes what it covers.
  template <typename Paint>
  void draw_line(std::int32_t line, Paint&& paint);

  // Of the last time that a pool did not do: the highest curve numbers were left out.
  const Status& status() const { return status_; }

 private:
  void plan(std::int32_t top);
  bool file_all(std::int32_t top, std::int32_t bottom);
  bool file(std::uint16_t curve, std::uint16_t piece, std::int32_t top, std::int32_t bottom);
  void begin_pieces(std::int32_t line);
  void begin(const Cubic& cubic, std::uint16_t curve, std::int32_t line);
  bool make_room(std::uint16_t curve, std::int32_t line);
  void insert(std::uint16_t index);
  Pen pen() const;
  std::uint16_t* draw_curve(std::uint16_t* link, std::int32_t line);

  Screen screen_;
  CurveStorage storage_;
  FreeList<StrandBlock, &StrandBlock::next> strands_;
  LineCoverage coverage_;
  SceneView scene_;
  CameraRecord camera_{};
  CurveReader reader_;
  std::uint16_t waiting_ = 0;           // pieces
  std::uint16_t alive_ = 0;             // strands in order of their curves
  std::int32_t line_ = 0;               // to be drawn next
  std::int32_t bottom_ = 0;             // where the lines to come end
  std::int32_t top_ = 0, planned_ = 0;  // the run of lines whose pieces are filed: [top_, planned_)
  bool afresh_ = true;                  // no strand is alive: those that began above the run begin again
  Status status_;
};

template <typename Paint>
void CurvePlotter::draw_line(std::int32_t line, Paint&& paint) {
  if (line == planned_) plan(line);
  begin_pieces(line);
  line_ = line + 1;
  for (std::uint16_t* link = &alive_; *link != 0;) {
    const Rgb8 color = strands_[*link].color;
    link = draw_curve(link, line);
    paint(color, coverage_);
  }
}

}  // namespace spanline
