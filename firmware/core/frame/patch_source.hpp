// Patches in a band: diced, culled and lit; the facets that are left wait here for their first line.
#pragma once

#include "core/base/pool.hpp"
#include "core/frame/patch_grids.hpp"

namespace spanline {

// A facet of a patch: a cell of its grid, or a triangle of one (CellParts). Corners lie beside each other in the vertex
// pool, so that two numbers name all four.
struct DicedFacet {
  enum Kind : std::uint8_t {
    kQuad,     // above, above + 1, below + 1, below
    kUpper,    // the first three of these
    kLower,    // the first and the last two
    kClipped,  // a plane of the view cut the cell: `below` corners follow each other from `above` on
  };
  std::uint16_t above;
  std::uint16_t below;
  std::uint16_t part : 13;  // its number within the patch, the same in every band
  std::uint16_t kind : 2;
  std::uint16_t payload;  // its colour, where it is flat
};
static_assert(sizeof(DicedFacet) == 8);

// The pools, erased.
struct PatchStorage {
  PoolRef<DicedFacet> facets;
  PoolRef<ScreenPoint> vertices;  // of the facets; two rows of the patch in the making stand at the end
  PoolRef<Normal10> normals;      // as many as vertices, or none: Gouraud patches are flat then
  std::uint32_t tolerance = 8;    // 1/16 px that a chord may be off its curve, at least 1
  PoolRef<GridVertex> grid{};     // the edge walker's
};

class PatchSource {
 public:
  PatchSource() = default;
  PatchSource(const PatchStorage& storage, const Screen& screen) : p_(storage), screen_(screen) {}

  // Forgets all facets; those to come are for the lines [top, bottom).
  void begin_band(std::int32_t top, std::int32_t bottom);

  // Dices the reader's current face, a patch, and keeps the facets that cover something of the band's lines. False
  // where a pool is full: at once, or, in a band of one line, after counting what it lacks.
  bool dice(const FacetReader& reader, const PatchLook& look);

  // The facets kept are numbered from 1 in the order of making.
  std::uint16_t count() const { return count_; }
  const DicedFacet& operator[](std::uint16_t index) const { return p_.facets[index]; }
  std::int32_t first_line(const DicedFacet& facet) const;
  // Whether it turns its front to the viewer; `mirrored`: its instance is.
  bool front(const DicedFacet& facet, bool mirrored) const;

  bool has_normals() const { return p_.normals.capacity() != 0; }

  // Hands the facet's contour to the sink as FacetReader::read does. `colour`: Normal10 to Rgb8, asked for where
  // has_normals().
  template <typename Colour, typename Sink>
  void read(const DicedFacet& facet, const Colour& colour, Sink& sink) const {
    sink.begin_contour();
    for (std::uint32_t i = 0; i < corner_count(facet); ++i) {
      const std::size_t at = corner(facet, i);
      const ScreenPoint& p = p_.vertices[at];
      sink.vertex(FacetVertex{p.at, p.depth, has_normals() ? colour(p_.normals[at]) : Rgb8{}});
    }
    sink.end_contour();
  }

  // The brightness over a facet that the view does not cut; brightness_of: Normal10 to Brightness, for its corners.
  static bool has_plane(const DicedFacet& facet) { return facet.kind != DicedFacet::kClipped; }
  template <typename BrightnessOf>
  BrightnessPlane plane(const DicedFacet& facet, const BrightnessOf& brightness_of) const {
    ScreenXY at[4];
    Brightness level[4];
    for (std::uint32_t i = 0; i < corner_count(facet); ++i) {
      at[i] = p_.vertices[corner(facet, i)].at;
      level[i] = brightness_of(p_.normals[corner(facet, i)]);
    }
    return facet.kind == DicedFacet::kQuad ? cell_brightness(at, level)
                                           : brightness_plane({at[0], at[1], at[2]}, {level[0], level[1], level[2]});
  }

  // The pool that the band lacked room in first, and how much.
  struct Shortage {
    const char* pool = nullptr;
    std::uint32_t needed = 0, limit = 0;
  };
  const Shortage& shortage() const { return shortage_; }

  // Since clear_statistics(): the pools' high-water marks, vertices computed.
  std::uint16_t most_facets() const { return most_facets_; }
  std::uint16_t most_vertices() const { return most_vertices_; }
  std::uint32_t points() const { return points_; }
  void clear_statistics() {
    most_facets_ = most_vertices_ = 0;
    points_ = 0;
  }

 private:
  struct Row;
  // The facets of a strip, a bit a column.
  struct Parts {
    std::uint64_t quads = 0, upper = 0, lower = 0;
    std::uint64_t any() const { return quads | upper | lower; }
  };

  static std::uint32_t corner_count(const DicedFacet& facet) {
    return facet.kind == DicedFacet::kClipped ? facet.below : facet.kind == DicedFacet::kQuad ? 4u : 3u;
  }
  static std::size_t corner(const DicedFacet& facet, std::uint32_t i) {
    if (facet.kind == DicedFacet::kLower && i > 0) ++i;
    return facet.kind == DicedFacet::kClipped || i < 2 ? facet.above + i : std::size_t{facet.below} + 3 - i;
  }

  static DicedFacet facet_at(const Row& above, std::uint16_t above_at, std::uint16_t below_at, std::uint32_t column);
  bool dice_rows(PatchJob& job);
  void step_off(const PatchJob& job, Row& row);
  bool reaches(const PatchJob& job, const DicedFacet& facet) const;
  bool shows_front(DicedFacet facet, bool mirrored) const;
  bool seen_clipped(const PatchJob& job, const DicedFacet& facet) const;
  void note_parts(const PatchJob& job, DicedFacet cell, std::uint64_t bit, Parts& whole) const;
  bool strip(const PatchJob& job, Row& above, Row& below);
  bool add_whole(const PatchJob& job, Row& above, Row& below, const Parts& parts);
  bool keep_row(const PatchJob& job, Row& row, std::uint32_t first, std::uint32_t end);
  bool take_vertices(const PatchJob& job, std::uint32_t count);
  bool add(const DicedFacet& facet);
  [[gnu::noinline]]  // the clipper's 500 bytes stay off the stack of the common path
  bool
  add_cut(const PatchJob& job, const Row& above, const Row& below, std::uint32_t column);
  std::uint32_t clip(const PatchJob& job, const Row& above, const Row& below, std::uint32_t column);
  static void take_corners(const PatchJob& job, const Row& row, std::uint32_t column, ClipVertex& a, ClipVertex& b);
  void colour(const PatchJob& job, const Row& above, const Row& below, std::uint16_t first);
  bool lacks_facet();
  bool lacks_vertices(std::uint32_t count);
  bool lacks(const Shortage& pool, std::uint32_t count);

  PatchStorage p_;
  Screen screen_;
  std::int32_t top_ = 0, bottom_ = 0;
  std::uint16_t count_ = 0, used_ = 0;  // facets and vertices kept
  std::uint16_t most_facets_ = 0, most_vertices_ = 0;
  Shortage shortage_;
  std::uint32_t points_ = 0;
};

}  // namespace spanline
