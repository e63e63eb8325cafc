#include "sim/host_memory.hpp"

#include <algorithm>

namespace spanline::host {
namespace {

template <typename T>
Slice<T> slice_of(std::vector<T>& items) {
  return {items.data(), static_cast<std::uint32_t>(items.size())};
}

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
  if (pool == "curves") return &curves;
  if (pool == "strands") return &strands;
  if (pool == "layers") return &layers;
  if (pool == "point_lines") return &point_lines;
  return nullptr;
}

PoolSizes pools_of(const Budget& budget) {
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
          .curves = budget.curves,
          .strands = budget.strands,
          .patch_tolerance = budget.patch_tolerance,
          .active = budget.active,
          .gouraud = budget.gouraud};
}

HostMemory::HostMemory(const Screen& screen, std::uint16_t band_lines, const PoolSizes& sizes)
    : screen_(screen),
      facets_(sizes.facets),
      buckets_(band_lines),
      vertices_(sizes.vertices),
      polygons_(sizes.polygons),
      edges_(sizes.edges),
      segments_(sizes.segments),
      shades_(sizes.gouraud ? sizes.segments : std::uint16_t{0}),
      active_(sizes.active != 0 ? sizes.active : sizes.segments),
      samples_{Blocks<std::int16_t>(sizes.samples), Blocks<std::int16_t>(sizes.samples)},
      implied_(sizes.implied),
      polygon_looks_(sizes.polygons),
      aside_(sizes.layers),
      stack_(sizes.layers),
      patch_facets_(sizes.patch_facets),
      patch_vertices_(sizes.patch_vertices),
      patch_normals_(sizes.gouraud ? sizes.patch_vertices : std::uint16_t{0}),
      patch_tolerance_(sizes.patch_tolerance),
      points_(sizes.vertices),
      links_(sizes.vertices),
      vertex_buckets_(screen.height),
      faces_(sizes.facets),
      active_edges_{Blocks<ActiveEdge>(sizes.edges), Blocks<ActiveEdge>(sizes.edges)},
      planes_(255),
      levels_(sizes.vertices),
      looks_(1023),
      tables_(15),
      points_of_band_(std::size_t{screen.width} * std::min(band_lines, sizes.point_lines)),
      faces_of_points_(points_of_band_.size()),
      pieces_(sizes.curves),
      piece_buckets_(band_lines),
      strands_(sizes.strands),
      masks_(screen.width) {}

FrameStorage HostMemory::storage() {
  overlay_.use({pieces_.ref(), piece_buckets_.ref(), strands_.ref(), masks_.ref()});
  return {screen_,
          facets_.ref(),
          buckets_.ref(),
          vertices_.ref(),
          {polygons_.ref(),
           edges_.ref(),
           segments_.ref(),
           shades_.ref(),
           active_.ref(),
           {samples_[0].ref(), samples_[1].ref()},
           implied_.ref(),
           nullptr,
           {polygon_looks_.ref(), aside_.ref(), stack_.ref()}},
          {patch_facets_.ref(), patch_vertices_.ref(), patch_normals_.ref(), patch_tolerance_},
          {{points_.ref(),
            links_.ref(),
            vertex_buckets_.ref(),
            {active_edges_[0].ref(), active_edges_[1].ref()},
            planes_.ref()},
           faces_.ref(),
           levels_.ref()},
          {looks_.ref(), tables_.ref()},
          &overlay_,
          {slice_of(points_of_band_), slice_of(faces_of_points_)}};
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
