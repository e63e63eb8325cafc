// A FrameMemory whose sizes are chosen at run time.
#pragma once

#include <string>
#include <vector>

#include "core/frame/budget.hpp"
#include "core/frame/scan_out.hpp"
#include "core/frame/storage.hpp"

namespace spanline::host {

struct PoolSizes {
  std::uint16_t facets = 65535, vertices = 65535, polygons = 65534, edges = 65534, segments = 65534, samples = 32767,
                implied = 32767, layers = 32767, patch_facets = 65534, patch_vertices = PatchStorage::kMostVertices,
                curves = 65535, strands = 4096, point_lines = kMaxExtent;
  std::uint16_t patch_tolerance = 8;  // 1/16 px
  std::uint16_t active = 0;           // as Budget has it
  bool gouraud = true;                // likewise

  // The size of the pool of this name (arguments.hpp), to read or set; null where there is none.
  std::uint16_t* find(const std::string& pool);
};

// What FrameMemory<budget> has, so that the picture is that of a board, too.
PoolSizes pools_of(const Budget& budget);

class HostMemory {
 public:
  // `band_lines`: the longest band, at least 1.
  HostMemory(const Screen& screen, std::uint16_t band_lines, const PoolSizes& sizes);
  HostMemory(const HostMemory&) = delete;
  HostMemory& operator=(const HostMemory&) = delete;

  FrameStorage storage();

 private:
  // The blocks and their sink.
  template <typename T>
  class Blocks {
   public:
    explicit Blocks(std::uint16_t capacity) : items_(std::size_t{capacity} + 1), capacity_(capacity) {}
    PoolRef<T> ref() { return {items_.data(), capacity_}; }

   private:
    std::vector<T> items_;
    std::uint16_t capacity_;
  };

  Screen screen_;
  Blocks<WaitingFacet> facets_;
  Blocks<std::uint16_t> buckets_;
  Blocks<ScreenPoint> vertices_;
  Blocks<PolygonBlock> polygons_;
  Blocks<EdgeBlock> edges_;
  Blocks<SegmentBlock> segments_;
  Blocks<SegmentShade> shades_;
  Blocks<ActiveSegment> active_;
  Blocks<std::int16_t> samples_[2];
  Blocks<ImpliedEdge> implied_;
  Blocks<PolygonLook> polygon_looks_;
  Blocks<ActiveSegment> aside_;
  Blocks<Layer> stack_;
  Blocks<DicedFacet> patch_facets_;
  Blocks<ScreenPoint> patch_vertices_;
  Blocks<Normal10> patch_normals_;
  std::uint16_t patch_tolerance_;
  Blocks<ScreenXY> points_;  // the edge walker's from here on
  Blocks<std::uint16_t> links_;
  Blocks<std::uint16_t> vertex_buckets_;
  Blocks<std::uint16_t> faces_;
  Blocks<ActiveEdge> active_edges_[2];
  Blocks<CachedPlane> planes_;
  Blocks<Brightness> levels_;
  Blocks<FaceLook> looks_;
  Blocks<ColorTable> tables_;
  std::vector<std::uint32_t> points_of_band_;
  std::vector<std::uint16_t> faces_of_points_;
  Blocks<WaitingPiece> pieces_;
  Blocks<std::uint16_t> piece_buckets_;
  Blocks<StrandBlock> strands_;
  Blocks<CoverageMask> masks_;
  CurveOverlay overlay_;
};

// A ScanOutMemory likewise.
class HostScanOutMemory {
 public:
  HostScanOutMemory(const Screen& screen, ScanPolicy policy, std::uint8_t window_bytes);
  HostScanOutMemory(const HostScanOutMemory&) = delete;
  HostScanOutMemory& operator=(const HostScanOutMemory&) = delete;

  ScanOutStorage storage();

 private:
  Screen screen_;
  ScanPolicy policy_;
  std::uint8_t window_bytes_;
  std::vector<Columns> lines_;
  std::vector<std::uint32_t> hashes_;
};

}  // namespace spanline::host
