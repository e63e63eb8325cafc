// The capacities of one application: the only place where memory is decided.
#pragma once

#include <cstdint>

#include "core/base/pixel_format.hpp"
#include "core/vsg/options.hpp"

namespace spanline {

// How much of a picture crosses the wire (ScanOut): every line whole; of each line what is covered or was; or of that
// the tiles, runs of 16 pixels, that have changed.
enum class ScanPolicy : std::uint8_t { full, extents, tiles };

struct Budget {
  std::uint16_t width = 320;   // px
  std::uint16_t height = 240;  // px
  PixelFormat format = PixelFormat::rgb565;
  std::uint16_t band_lines = 0;  // longest band, lines; 0: the whole height
  std::uint16_t facets = 512;    // facets of a band that wait for their first line: 4 bytes each
  std::uint16_t vertices = 576;  // projected vertices kept; the rest are projected again at each use: 8 bytes each
  std::uint16_t polygons = 64;   // facets alive on one line
  std::uint16_t edges = 48;      // edges of those that wait for their first line
  std::uint16_t segments = 64;   // segments alive on one line
  std::uint16_t active = 0;      // segments over one pixel, 16 bytes each; 0: as many as segments
  std::uint16_t samples = 64;    // sample points kept for the next line (a hint: dropped when full)
  std::uint16_t implied = 16;    // implied edges kept (a hint)
  // Where the scene has patches (FrameOptions::patches):
  std::uint16_t patch_facets = 0;    // of the facets that wait, those of patches: 8 bytes each, more
  std::uint16_t patch_vertices = 0;  // their corners and two rows of a patch's grid: 8 bytes each, 4 more with gouraud
  std::uint16_t patch_grid = 0;      // with the edge walker, which takes no other of these: vertices of grids, 12 bytes
                                     // each, and one more a patch
  std::uint16_t patch_tolerance = 8;  // 1/16 px that an edge of a facet may be off the patch: 8 is half a pixel
  // The other way of drawing them (FrameOptions::points): as points, into a band of so many lines at most, 4 bytes a
  // pixel; 0: they are diced.
  std::uint16_t point_lines = 0;
  std::uint16_t layers = 0;   // segments of surface detail and of see-through polygons over one pixel, 40 bytes
                              // each, and 8 more a polygon; 0: a scene without either
  std::uint16_t curves = 0;   // pieces of curves in a band that wait for their first line: 6 bytes each
  std::uint16_t strands = 0;  // y-monotone pieces of curves alive on one line, 112 bytes each; 0: no curves are drawn
  std::uint16_t lines = 0;    // edges of all that is visible, 14 bytes each: the picture is of lines, and the pools are
                              // those of LineMemory; 0: of surfaces
  bool gouraud = true;        // room for colours along edges, 28 bytes a segment; without it Gouraud facets are flat
  // Whose pools there are: those of FrameOptions::walker. The edge walker keeps every face (2 bytes each, or one where
  // gouraud: `facets`), the place of every vertex (6 bytes each, 7 where gouraud: `vertices`), the edges of one line,
  // which may be shared by two faces (32 bytes each, `edges`), and some depth planes. For the other pools see above.
  Walker walker = Walker::segments;
  // With Walker::edges and meshes: that many vertices, 8 bytes each and 126 at most, are kept of a band, which is the
  // run of lines that reach no more of them, or of band_lines, a byte each. Of every face then only a bit is kept
  // (`facets`), of every vertex a byte (`vertices`); 0: everything is kept.
  std::uint16_t band_vertices = 0;
  // Likewise instances whose matrices are kept, 120 bytes each (160 on an M0+), and one more is there: where faces of
  // several overlap on the screen these come by turns.
  std::uint16_t band_instances = 1;
  // Where gouraud: looks of smooth triangles kept, 16 bytes each, and tables of their materials' colours, 130 bytes
  // each. Powers of two less one, since one more of each is there; of looks the edge walker takes any number up to 254.
  // looks 0: 15 for the segment walker, 127 for the others. With band_vertices
  // likewise any number, 17 bytes each and a byte for each of 256 faces; without gouraud colours of faces, 4 bytes
  // each, a power of two less one.
  std::uint16_t looks = 0, tables = 0;
  // Depth planes kept, a power of two less one; one more is there, and with each how far four faces reach: 40 bytes.
  std::uint16_t planes = 15;
  // Instances that are compared with the frame before, so that lines on which nothing has moved are not drawn again
  // (ChangedLines), 76 bytes each, and a bit a line; 0: every line is drawn in every frame.
  std::uint16_t kept_instances = 0;
  // With Walker::edges, meshes and RGB565: that scenes are plain, as most are, which takes 2 KB less code. They have
  // one light, neither black nor with a hue nor together with the ambient light above 256 (Q8.8), which has none
  // either; a background of one colour; no curves; meshes that are turned and scaled alike in all directions and not
  // mirrored, each with a normal a face, or a vertex where gouraud, and then no other materials. Any other is refused:
  // bad_argument, "plain" and what is not. Transforms may change from frame to frame; lights, materials and flags are
  // looked at where the SceneView is made.
  bool plain = false;
  ScanPolicy scan_out = ScanPolicy::full;  // ScanOutMemory: extents take 4 bytes a line, tiles 4 more for each tile
};

}  // namespace spanline
