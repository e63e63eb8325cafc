#include "sim/host_memory.hpp"

#include <algorithm>

namespace spanline::host {
namespace {

constexpr std::uint16_t kNoBlocks = 0;

}  // namespace

std::uint16_t* PoolSizes::find(const std::string& pool) {
  if (pool == "facets") return &facets;
  if (pool == "vertices") return &vertices;
  if (pool == "polygons") return &polygons;
  if (pool == "edges") return &edges;
  if (pool == "segments") return &segments;
  if (pool == "samples") return &samples;
  if (pool == "implied") return &implied;
  if (pool == "patch_facets") return &patch_facets;
  if (pool == "patch_vertices") return &patch_vertices;
  if (pool == "patch_grid") return &patch_grid;
  if (pool == "curves") return &curves;
  if (pool == "strands") return &strands;
  if (pool == "layers") return &layers;
  if (pool == "point_lines") return &point_lines;
  return nullptr;
}

PoolSizes pools_of(const Budget& budget) {
  const std::uint16_t default_looks = budget.walker == Walker::segments ? 15 : 127;
  return {.facets = budget.facets,
          .vertices = budget.vertices,
          .polygons = budget.polygons,
          .edges = budget.edges,
          .segments = budget.segments,
          .samples = budget.samples,
          .implied = budget.implied,
          .layers = budget.layers,
          .patch_facets = budget.patch_facets,
          .patch_vertices = budget.patch_vertices,
          .patch_grid = budget.patch_grid,
          .curves = budget.curves,
          .strands = budget.strands,
          .point_lines = budget.point_lines,
          .patch_tolerance = budget.patch_tolerance,
          .active = budget.active,
          .gouraud = budget.gouraud,
          .looks = budget.looks != 0 ? budget.looks : default_looks,
          .tables = budget.tables,
          .planes = budget.planes,
          .band_vertices = budget.band_vertices,
          .band_instances = budget.band_instances};
}

template <typename T>
Slice<T> HostMemory::take_items(std::uint32_t count) {
  const auto items = std::make_shared<std::vector<T>>(count);
  owned_.push_back(items);
  bytes_ += count * sizeof(T);
  return {items->data(), count};
}

template <typename T>
PoolRef<T> HostMemory::take(std::uint16_t capacity) {
  return {take_items<T>(std::uint32_t{capacity} + 1).data(), capacity};
}

void HostMemory::take_segment_pools(std::uint16_t band_lines, const PoolSizes& sizes) {
  storage_.facets = take<WaitingFacet>(sizes.facets);
  storage_.buckets = take<std::uint16_t>(band_lines);
  storage_.vertices = take<ScreenPoint>(sizes.vertices);
  VsgStorage& vsg = storage_.vsg;
  vsg.polygons = take<PolygonBlock>(sizes.polygons);
  vsg.edges = take<EdgeBlock>(sizes.edges);
  vsg.segments = take<SegmentBlock>(sizes.segments);
  vsg.shades = take<SegmentShade>(sizes.gouraud ? sizes.segments : kNoBlocks);
  vsg.active = take<ActiveSegment>(sizes.active != 0 ? sizes.active : sizes.segments);
  for (PoolRef<std::int16_t>& samples : vsg.samples) samples = take<std::int16_t>(sizes.samples);
  vsg.implied = take<ImpliedEdge>(sizes.implied);
  if (sizes.has(sizes.layers)) {
    vsg.layers = {take<PolygonLook>(sizes.polygons), take<ActiveSegment>(sizes.layers), take<Layer>(sizes.layers)};
  }
  if (!sizes.has(sizes.patch_facets)) return;
  storage_.patches = {take<DicedFacet>(sizes.patch_facets), take<ScreenPoint>(sizes.patch_vertices),
                      take<Normal10>(sizes.gouraud ? sizes.patch_vertices : kNoBlocks), sizes.patch_tolerance,
                      storage_.patches.grid};
}

void HostMemory::take_mesh_pools(std::uint16_t lines, const PoolSizes& sizes) {
  if (sizes.band_vertices != 0) {
    storage_.bands = {
        take<std::uint32_t>(static_cast<std::uint16_t>(BitPool::words_for(sizes.facets))),
        take<std::uint8_t>(sizes.vertices),
        take<BandVertex>(sizes.band_vertices),
        take<std::uint8_t>(lines),
        take<FaceColor>(sizes.gouraud ? kNoBlocks : sizes.looks),
        take<std::uint8_t>(sizes.gouraud ? static_cast<std::uint16_t>(LookChains::heads_for(sizes.facets) - 1)
                                         : kNoBlocks),
        take<std::uint8_t>(sizes.gouraud ? sizes.looks : kNoBlocks),
        take<BandInstance>(sizes.band_instances)};
  }
  EdgeStorage& walker = storage_.mesh.walker;
  walker.points = take<ScreenXY>(sizes.vertices);
  walker.links = take<std::uint16_t>(sizes.vertices);
  walker.buckets = take<std::uint16_t>(lines);
  for (PoolRef<ActiveEdge>& edges : walker.edges) edges = take<ActiveEdge>(sizes.edges);
  walker.planes = take<CachedPlane>(sizes.planes);
  walker.reaches = take<DepthReach>(PlaneCache::reaches_for(sizes.planes));
  storage_.mesh.faces = take<std::uint16_t>(sizes.gouraud ? kNoBlocks : sizes.facets);
  storage_.mesh.slots = take<std::uint8_t>(sizes.gouraud ? sizes.facets : kNoBlocks);
  storage_.mesh.levels = take<Brightness>(sizes.gouraud ? sizes.vertices : kNoBlocks);
  storage_.patches.tolerance = sizes.patch_tolerance;
  if (sizes.has(sizes.patch_grid)) storage_.patches.grid = take<GridVertex>(sizes.patch_grid);
}

void HostMemory::take_curve_pools(const Screen& screen, std::uint16_t band_lines, const PoolSizes& sizes) {
  if (!sizes.has(sizes.strands)) return;
  overlay_.use({take<WaitingPiece>(sizes.curves), take<std::uint16_t>(band_lines), take<StrandBlock>(sizes.strands),
                take<CoverageMask>(screen.width)});
  storage_.curves = &overlay_;
}

// Who looks at the faces is not on a board.
void HostMemory::take_points(const Screen& screen, std::uint16_t band_lines, const PoolSizes& sizes) {
  const std::uint32_t cells = std::uint32_t{screen.width} * std::min(band_lines, sizes.point_lines);
  storage_.points = {take_items<std::uint32_t>(cells), take_items<std::uint16_t>(sizes.exact ? 0 : cells)};
}

HostMemory::HostMemory(const Screen& screen, std::uint16_t band_lines, const PoolSizes& sizes) {
  storage_.screen = screen;
  if (sizes.walker != Walker::edges) take_segment_pools(band_lines, sizes);
  if (sizes.walker != Walker::segments) take_mesh_pools(screen.height, sizes);
  if (sizes.gouraud) storage_.smooth = {take<FaceLook>(sizes.looks), take<ColorTable>(sizes.tables)};
  take_curve_pools(screen, band_lines, sizes);
  take_points(screen, band_lines, sizes);
}

HostScanOutMemory::HostScanOutMemory(const Screen& screen, ScanPolicy policy, std::uint8_t window_bytes)
    : screen_(screen),
      policy_(policy),
      window_bytes_(window_bytes),
      lines_(screen.height),
      hashes_(tiles_per_line(screen.width) * screen.height) {}

ScanOutStorage HostScanOutMemory::storage() {
  return {screen_,
          policy_,
          {lines_.data(), static_cast<std::uint32_t>(lines_.size())},
          {hashes_.data(), static_cast<std::uint32_t>(hashes_.size())},
          window_bytes_};
}

}  // namespace spanline::host
