// FrameMemory: the only storage of a frame, sized by its budget.
#pragma once

#include <type_traits>

#include "core/base/bit_pool.hpp"
#include "core/frame/budget.hpp"
#include "core/frame/changed_lines.hpp"
#include "core/frame/curve_overlay.hpp"
#include "core/frame/instance_points.hpp"
#include "core/frame/patch_grids.hpp"
#include "core/frame/patch_source.hpp"
#include "core/frame/point_source.hpp"
#include "core/shade/brightness.hpp"
#include "core/shade/face_colors.hpp"
#include "core/shade/look_chains.hpp"
#include "core/vsg/band_vertices.hpp"
#include "core/vsg/edge_walker.hpp"
#include "core/vsg/visible_segments.hpp"

namespace spanline {

// A facet that waits for its first line in a Y-bucket.
struct WaitingFacet {
  std::uint16_t next;
  std::uint16_t face;
};

// What the edge walker's side of a frame uses.
struct MeshStorage {
  EdgeStorage walker;
  PoolRef<std::uint16_t> faces;  // of the scene: the colour of each, where all are flat
  PoolRef<std::uint8_t> slots;   // else the number of its look among those that are kept
  PoolRef<Brightness> levels;    // of vertices, where Gouraud's materials are drawn as such
};

// What it uses where only a band's vertices are kept, instead of a place for each face and vertex. EdgeStorage::points
// are then those of a mesh whose faces are culled, if they fit; all but the first two of these, the walker's other
// pools and the looks may lie over them.
struct BandStorage {
  PoolRef<std::uint32_t> drawn;   // a bit a face
  PoolRef<std::uint8_t> keys;     // a byte a vertex
  PoolRef<BandVertex> vertices;   // of a band
  PoolRef<std::uint8_t> buckets;  // a line of a band each
  PoolRef<FaceColor> colors;      // where all faces are flat
  PoolRef<std::uint8_t> heads;    // else LookChains'
  PoolRef<std::uint8_t> links;
  PoolRef<BandInstance> instances;  // asked for last; the sink is used, too
};

// A FrameMemory with its sizes erased. Limit any pool before handing it to a Frame; the picture stays the same as long
// as a line fits.
struct FrameStorage {
  Screen screen;
  PoolRef<WaitingFacet> facets;
  PoolRef<std::uint16_t> buckets;  // one a line; its capacity is the longest band
  PoolRef<ScreenPoint> vertices;
  VsgStorage vsg;
  PatchStorage patches;
  MeshStorage mesh;
  SmoothStorage smooth;
  CurveOverlay* curves = nullptr;  // null: curves are not drawn
  PointStorage points = {};
  ChangesStorage changes = {};
  BandStorage bands = {};
};

// How many looks a budget keeps.
constexpr std::uint16_t looks_of(const Budget& budget) {
  if (budget.looks != 0) return budget.looks;
  return budget.walker == Walker::segments ? 15 : 127;
}

// The pools of smooth triangles, where there are any.
template <std::uint16_t kLooks, std::uint16_t kTables, bool kSmooth>
class SmoothPools {
 public:
  constexpr SmoothStorage storage() { return {looks_.ref(), tables_.ref()}; }

 private:
  Pool<FaceLook, kLooks> looks_;
  Pool<ColorTable, kTables> tables_;
};
template <std::uint16_t kLooks, std::uint16_t kTables>
class SmoothPools<kLooks, kTables, false> {
 public:
  constexpr SmoothStorage storage() { return {}; }
};

// Where the looks are pools of somebody else.
template <std::uint16_t kTables>
class SmoothPools<0, kTables, true> {
 public:
  constexpr SmoothStorage storage() { return {{}, tables_.ref()}; }

 private:
  Pool<ColorTable, kTables> tables_;
};

template <Budget kBudget>
class CurvePools {
 public:
  constexpr void add_to(FrameStorage& storage) {
    overlay_.use({pieces_.ref(), buckets_.ref(), strands_.ref(), masks_.ref()});
    storage.curves = &overlay_;
  }

 private:
  Pool<WaitingPiece, kBudget.curves> pieces_;
  Pool<std::uint16_t, kBudget.band_lines == 0 ? kBudget.height : kBudget.band_lines> buckets_;
  Pool<StrandBlock, kBudget.strands> strands_;
  Pool<CoverageMask, kBudget.width> masks_;
  CurveOverlay overlay_;
};

// The pools of patches, where there are any.
template <std::uint16_t kFacets, std::uint16_t kVertices, bool kNormals>
class PatchMemory {
 public:
  constexpr PatchStorage storage(std::uint32_t tolerance) {
    return {facets_.ref(), vertices_.ref(), normals_.ref(), tolerance};
  }

 private:
  Pool<DicedFacet, kFacets> facets_;
  Pool<ScreenPoint, kVertices> vertices_;
  Pool<Normal10, kNormals ? kVertices : 0> normals_;
};
template <std::uint16_t kVertices, bool kNormals>
class PatchMemory<0, kVertices, kNormals> {
 public:
  constexpr PatchStorage storage(std::uint32_t) { return {}; }
};

// The band of points.
template <std::uint32_t kCells>
class PointPools {
 public:
  constexpr void add_to(FrameStorage& storage) { storage.points = {Slice<std::uint32_t>(cells_), {}}; }

 private:
  std::uint32_t cells_[kCells];
};
template <>
class PointPools<0> {
 public:
  constexpr void add_to(FrameStorage&) {}
};

// What is known of the frame before.
template <std::uint16_t kInstances, std::uint32_t kLines>
class KeptMemory {
 public:
  constexpr void add_to(FrameStorage& storage) { storage.changes = {instances_, lines_}; }

 private:
  KeptInstance instances_[kInstances];
  std::uint32_t lines_[(kLines + 31) / 32];
};
template <std::uint32_t kLines>
class KeptMemory<0, kLines> {
 public:
  constexpr void add_to(FrameStorage&) {}
};

// The pools of one walker.
template <Budget kBudget>
class SegmentPools {
  static_assert(kBudget.facets > 0 && kBudget.polygons > 0 && kBudget.segments > 0, "these pools cannot be empty");
  static_assert(kBudget.patch_tolerance > 0, "Budget::patch_tolerance is out of range");
  static constexpr std::uint16_t kBandLines = kBudget.band_lines == 0 ? kBudget.height : kBudget.band_lines;

 public:
  constexpr void add_to(FrameStorage& storage) {
    storage.facets = facets_.ref();
    storage.buckets = buckets_.ref();
    storage.vertices = vertices_.ref();
    storage.vsg = {polygons_.ref(), edges_.ref(),  segments_.ref(),
                   shades_.ref(),   active_.ref(), {samples_[0].ref(), samples_[1].ref()},
                   implied_.ref(),  nullptr,       {}};
    if constexpr (kBudget.layers != 0) storage.vsg.layers = layers_.storage();
    storage.patches = patches_.storage(kBudget.patch_tolerance);
  }

 private:
  struct NoLayerPools {};
  struct LayerPools {
    Pool<PolygonLook, kBudget.polygons> looks;
    Pool<ActiveSegment, kBudget.layers> aside;
    Pool<Layer, kBudget.layers> stack;
    constexpr LayerStorage storage() { return {looks.ref(), aside.ref(), stack.ref()}; }
  };

  Pool<WaitingFacet, kBudget.facets> facets_;
  Pool<std::uint16_t, kBandLines> buckets_;
  Pool<ScreenPoint, kBudget.vertices> vertices_;
  Pool<PolygonBlock, kBudget.polygons> polygons_;
  Pool<EdgeBlock, kBudget.edges> edges_;
  Pool<SegmentBlock, kBudget.segments> segments_;
  Pool<SegmentShade, kBudget.gouraud ? kBudget.segments : 0> shades_;
  Pool<ActiveSegment, kBudget.active == 0 ? kBudget.segments : kBudget.active> active_;
  Pool<std::int16_t, kBudget.samples> samples_[2];
  Pool<ImpliedEdge, kBudget.implied> implied_;
  [[no_unique_address]] PatchMemory<kBudget.patch_facets, kBudget.patch_vertices, kBudget.gouraud> patches_;
  [[no_unique_address]] std::conditional_t<kBudget.layers != 0, LayerPools, NoLayerPools> layers_;
};

template <Budget kBudget>
class MeshPools {
 public:
  constexpr void add_to(FrameStorage& storage) {
    if constexpr (kBudget.patch_grid != 0) {
      storage.patches.grid = grid_.ref();
      storage.patches.tolerance = kBudget.patch_tolerance;
    }
    storage.mesh = {{points_.ref(),
                     links_.ref(),
                     buckets_.ref(),
                     {edges_[0].ref(), edges_[1].ref()},
                     planes_.ref(),
                     reaches_.ref()},
                    faces_.ref(),
                    slots_.ref(),
                    levels_.ref()};
  }

 private:
  Pool<ScreenXY, kBudget.vertices> points_;
  Pool<std::uint16_t, kBudget.vertices> links_;
  Pool<std::uint16_t, kBudget.height> buckets_;
  Pool<std::uint16_t, kBudget.gouraud ? 0 : kBudget.facets> faces_;
  Pool<std::uint8_t, kBudget.gouraud ? kBudget.facets : 0> slots_;
  Pool<ActiveEdge, kBudget.edges> edges_[2];
  Pool<CachedPlane, kBudget.planes> planes_;
  Pool<DepthReach, PlaneCache::reaches_for(kBudget.planes)> reaches_;
  Pool<Brightness, kBudget.gouraud ? kBudget.vertices : 0> levels_;
  struct NoGrid {};
  [[no_unique_address]] std::conditional_t<kBudget.patch_grid != 0, Pool<GridVertex, kBudget.patch_grid>, NoGrid> grid_;
};

// Likewise where only a band's vertices are kept. What is made for a line is not there yet while faces are culled, and
// the vertices of a mesh are in its place.
template <Budget kBudget>
class BandPools {
 public:
  constexpr void add_to(FrameStorage& storage) {
    LinePools& of = shared_.of_lines;
    storage.mesh.walker.points = {shared_.points, kPoints};
    storage.mesh.walker.edges[0] = of.edges.ref();
    storage.mesh.walker.planes = of.planes.ref();
    storage.mesh.walker.reaches = of.reaches.ref();
    storage.bands = {drawn_.ref(),    keys_.ref(),    of.vertices.ref(), of.buckets.ref(),
                     of.colors.ref(), of.heads.ref(), of.links.ref(),    instances_.ref()};
    if constexpr (kBudget.gouraud) storage.smooth.looks = of.looks.ref();
  }

 private:
  struct NoLooks {};
  struct LinePools {
    Pool<BandVertex, kBudget.band_vertices> vertices;
    Pool<std::uint8_t, kBudget.band_lines == 0 ? kBudget.height : kBudget.band_lines> buckets;
    Pool<ActiveEdge, kBudget.edges> edges;
    Pool<CachedPlane, kBudget.planes> planes;
    Pool<DepthReach, PlaneCache::reaches_for(kBudget.planes)> reaches;
    Pool<FaceColor, kBudget.gouraud ? 0 : looks_of(kBudget)> colors;
    Pool<std::uint8_t, kBudget.gouraud ? LookChains::heads_for(kBudget.facets) - 1 : 0> heads;
    Pool<std::uint8_t, kBudget.gouraud ? looks_of(kBudget) : 0> links;
    [[no_unique_address]] std::conditional_t<kBudget.gouraud, Pool<FaceLook, looks_of(kBudget)>, NoLooks> looks;
  };
  static constexpr std::size_t kRoom = sizeof(LinePools) / sizeof(ScreenXY) - 1;
  static constexpr std::uint16_t kPoints = kRoom < kBudget.vertices ? std::uint16_t{kRoom} : kBudget.vertices;
  union Shared {
    Shared() {}  // NOLINT: default means deleted where a member has a constructor
    LinePools of_lines;
    ScreenXY points[kPoints + 1];
  };

  Pool<std::uint32_t, BitPool::words_for(kBudget.facets)> drawn_;
  Pool<std::uint8_t, kBudget.vertices> keys_;
  Pool<BandInstance, kBudget.band_instances> instances_;
  Shared shared_;
};

struct NoPools {
  constexpr void add_to(FrameStorage&) {}
};
struct NoCurves {  // not NoPools, so that neither takes room
  constexpr void add_to(FrameStorage&) {}
};

template <Budget kBudget>
class FrameMemory {
  static_assert(kBudget.width > 0 && kBudget.width <= kMaxExtent, "Budget::width is out of range");
  static_assert(kBudget.height > 0 && kBudget.height <= kMaxExtent, "Budget::height is out of range");
  static_assert(kBudget.band_vertices == 0 || (kBudget.walker == Walker::edges && kBudget.patch_grid == 0),
                "Budget::band_vertices are of meshes, for the edge walker");
  static_assert(kBudget.patch_grid <= GridVertex::kMost, "Budget::patch_grid is out of range");

 public:
  constexpr FrameStorage storage() {
    FrameStorage storage{{kBudget.width, kBudget.height, kBudget.format}, {}, {}, {}, {}, {}, {}, smooth_.storage()};
    segments_.add_to(storage);
    mesh_.add_to(storage);
    curves_.add_to(storage);
    points_.add_to(storage);
    kept_.add_to(storage);
    return storage;
  }

 private:
  [[no_unique_address]] std::conditional_t<kBudget.walker == Walker::edges, NoPools, SegmentPools<kBudget>> segments_;
  [[no_unique_address]] std::conditional_t<
      kBudget.walker == Walker::segments, NoPools,
      std::conditional_t<kBudget.band_vertices != 0, BandPools<kBudget>, MeshPools<kBudget>>>
      mesh_;
  static constexpr std::uint16_t kLooks = kBudget.band_vertices != 0 ? std::uint16_t{0} : looks_of(kBudget);
  [[no_unique_address]] SmoothPools<kLooks, kBudget.tables, kBudget.gouraud> smooth_;
  [[no_unique_address]] std::conditional_t<kBudget.strands == 0, NoCurves, CurvePools<kBudget>> curves_;
  [[no_unique_address]] PointPools<std::uint32_t{kBudget.point_lines} * kBudget.width> points_;
  [[no_unique_address]] KeptMemory<kBudget.kept_instances, kBudget.height> kept_;
};

}  // namespace spanline
