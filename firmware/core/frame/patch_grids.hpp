// Patches for the edge walker: what a run of lines needs of their grids. A cell has no record of its own: its first
// corner carries its colour, and which faces an edge parts follows from where its ends stand in the grid.
#pragma once

#include "core/base/pool.hpp"
#include "core/frame/patch_job.hpp"
#include "core/shade/facet_light.hpp"
#include "core/vsg/active_edge.hpp"
#include "core/vsg/depth.hpp"
#include "core/vsg/plane_cache.hpp"

namespace spanline {

// A vertex of a grid, and the cell between it and the next one along both directions. Each grid is preceded by an entry
// that is no vertex: at.x is how many rows of vertices it has, `color` the patch's number in the scene.
struct GridVertex {
  static constexpr std::uint16_t kMost = 8191;  // `next`

  std::uint16_t color;      // of the cell, as flat_payload() has it; where patches are smooth the vertex's Brightness,
                            // above it the number of the cell's look (GridLooks). Here for grid_walk()
  std::uint16_t next : 13;  // in the list of those that are filed under one line
  std::uint16_t parts : 3;  // CellParts of the cell; none in the last row and column
  ScreenXY at;
  std::uint32_t depth : 24;     // Q16.8
  std::uint32_t stride : 7;     // vertices of a row
  std::uint32_t first_row : 1;  // no cells lie above

  // A vertex of no cell, in a row of `of` vertices, the first one or another.
  struct InRow {
    std::uint32_t word;
    InRow(std::uint32_t of, bool first) : word(of << 24 | (first ? 1u << 31 : 0u)) {}
  };
  // By words, which compilers do not make of bit fields.
  static void put(GridVertex* to, const ScreenPoint& p, const InRow& row) {
    put_words(to, PackedXY(p.at).word, p.depth | row.word);
  }
  // The same of a point that is to be projected.
  static void put(GridVertex* to, const Projection& projection, const ClipPoint& p, const InRow& row) {
    std::uint32_t at = 0, depth = 0;
    projection.put(p, row.word, at, depth);
    put_words(to, at, depth);
  }

 private:
  static void put_words(GridVertex* to, std::uint32_t xy, std::uint32_t depth) {
    const std::uint32_t words[3] = {0, xy, depth};
    auto* const out = static_cast<char*>(__builtin_assume_aligned(to, alignof(GridVertex)));
    for (int i = 0; i < 3; ++i) __builtin_memcpy(out + 4 * i, &words[i], 4);
  }
};
static_assert(sizeof(GridVertex) == 12 && kMaxSteps + 1 < 1 << 7);

// A face on a line, between its two edges there, in whole units: 28.4 px, off by less than one, and depths of 1/65536,
// less by two or greater by one at most.
struct GridChord {
  std::int32_t x, depth;     // of one edge
  std::int32_t width, rise;  // to the other

  // The depth in a column's middle, where it covers that: by what its fraction of the width is off, steepness() at
  // most, and a unit farther off than depths at the edges are.
  std::int32_t depth_at(std::int32_t column) const {
    if (width == 0) return depth;
    static_assert(0xffff * std::int64_t{kMaxExtent * kSubpixels + 1} <= INT32_MAX, "rise along the width");
    return depth + rise * (column * kSubpixels + kSubpixels / 2 - x) / width;
  }
  std::int32_t steepness() const {
    const std::int32_t units = width == 0 ? rise : rise / width;
    return (units < 0 ? -units : units) + 1;
  }
};

class PatchGrids {
 public:
  PatchGrids() = default;
  PatchGrids(PoolRef<GridVertex> vertices, const Screen& screen, std::uint32_t tolerance)
      : v_(vertices), screen_(screen), tolerance_(tolerance) {
    v_.limit(GridVertex::kMost);
  }

  // Forgets all grids; those to come are for lines [top, bottom).
  void begin(std::int32_t top, std::int32_t bottom);
  // Forgets what lies on `bottom` and below.
  void shrink(std::int32_t bottom);
  std::int32_t bottom() const { return bottom_; }

  // Dices the reader's current face, a patch inside the view, and keeps the cells that face the viewer, or all where it
  // is two-sided, that may cover something of the lines. False where there is no room for all of them; then none is
  // kept.
  bool dice(const PatchJob& job, const FacetLight& light, std::uint16_t face);
  // Whether dice() is for it: otherwise some control point lies outside of the view, or at its very border.
  static bool takes(const PatchJob& job) { return job.well_inside; }
  DiceView view(const CameraRecord& camera) const { return {camera, screen_, tolerance_}; }

  std::uint32_t most() const { return most_; }  // entries in use at once, since begin_frame()
  void begin_frame() { most_ = 0; }
  std::uint16_t capacity() const { return v_.capacity(); }
  void set_background(std::uint16_t color) { v_[0].color = color; }

  // Files every vertex with a cell under its first line, or under the run's: those of bucket[1 + line - top] are a list
  // through `next`.
  void file(const PoolRef<std::uint16_t>& buckets);

  const GridVertex& operator[](std::uint32_t vertex) const { return v_[vertex]; }

  // Cells are named as faces by twice the number of their first vertex, their lower triangles, where those are apart,
  // by one more.
  std::uint16_t color(FaceId face) const { return v_[face / 2u].color; }
  // The same where patches are smooth: the number of the face's look, 0 at first, and its brightness.
  std::uint8_t look(FaceId face) const { return static_cast<std::uint8_t>(color(face) >> 8); }
  void set_look(FaceId face, std::uint8_t number) {
    std::uint16_t& word = v_[face / 2u].color;
    word = static_cast<std::uint16_t>((word & 0xffu) | std::uint32_t{number} << 8);
  }
  BrightnessPlane brightness(FaceId face) const;
  // The corners of a face, counter-clockwise if it shows its front; returns how many.
  std::uint32_t corners(FaceId face, const GridVertex* (&corner)[4]) const;
  // Whether a face shows its back, which clockwise corners do.
  bool is_back(FaceId face) const;
  // The edge of a face that crosses `line` and runs down (on its left, if it shows its front) or up. False where none
  // does.
  bool find_edge(FaceId face, std::int32_t line, bool down, ScreenEdge& edge) const;
  // What its corners' depths lie between, in units of 1/65536 less half the range; nearer ones are greater.
  void reach(FaceId face, DepthReach& to) const;
  // Roughly where it runs along a line that it covers a pixel of.
  GridChord chord(FaceId face, std::int32_t line) const;
  // Its depth along a line that it covers a pixel of.
  DepthRamp ramp(FaceId face, std::int32_t line) const;
  // The number of its patch in the scene.
  std::uint16_t scene_face(FaceId face) const;

 private:
  struct Open;
  struct Row;
  using Light = FacetLight::Of;

  ClipPoint* points_at(std::uint32_t first, std::uint32_t count) const;
  void strip(const PatchJob& job, const Light& light, Open& grid, const Row& above, const Row& below);
  bool step_off(const PatchJob& job, const Row& row, const Open& grid, std::uint32_t to);
  static void color(const PatchJob& job, const Light& light, GridVertex* cells, const Row& above, const Row& below);
  [[gnu::noinline]] static void color_any(const PatchJob& job, const Light& light, GridVertex* cells, const Row& above,
                                          const Row& below);
  static bool note_parts(const PatchJob& job, GridVertex* above, const GridVertex* below);
  void close(const PatchJob& job, Open& grid);
  void light(const PatchJob& job, std::uint32_t header, std::uint32_t row);
  void light_row(const LightRig& rig, const PatchTangents& tangents, std::uint32_t first, std::uint32_t column,
                 std::uint32_t row);
  // Whether a cell around the vertex, of rows of `stride`, is drawn.
  bool has_cell(std::uint32_t vertex, std::uint32_t stride) const {
    std::uint32_t around = std::uint32_t{v_[vertex].parts} | v_[vertex - 1].parts;
    if (v_[vertex].first_row == 0) around |= std::uint32_t{v_[vertex - stride].parts} | v_[vertex - stride - 1].parts;
    return around != CellParts::kNone;
  }
  // take(top, bottom, whether it runs down) for a face's edges that cross a line, one that does and one that runs up.
  template <typename Take>
  void each_crossing(FaceId face, std::int32_t line, const Take& take) const;
  std::uint32_t pack(std::uint32_t from, std::uint32_t to);
  std::uint32_t size(std::uint32_t header) const {
    return 1 + static_cast<std::uint32_t>(v_[header].at.x) * v_[header].stride;
  }

  PoolRef<GridVertex> v_;
  Screen screen_;
  std::uint32_t tolerance_ = 8;
  std::int32_t top_ = 0, bottom_ = 0;
  std::uint16_t used_ = 0;
  std::uint32_t most_ = 0;
};

}  // namespace spanline
