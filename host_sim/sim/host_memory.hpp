// A FrameMemory whose sizes are chosen at run time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/frame/budget.hpp"
#include "core/frame/scan_out.hpp"
#include "core/frame/storage.hpp"

namespace spanline::host {

struct PoolSizes {
  std::uint16_t facets = 65535, vertices = 65535, polygons = 65534, edges = 65534, segments = 65534, samples = 32767,
                implied = 32767, layers = 32767, patch_facets = 65534, patch_vertices = 65534,
                patch_grid = GridVertex::kMost, curves = 65535, strands = 4096, point_lines = kMaxExtent;
  std::uint16_t patch_tolerance = 8;  // 1/16 px
  std::uint16_t active = 0;           // as Budget has it
  bool gouraud = true;                // likewise
  std::uint16_t looks = 1023, tables = 15, planes = 255;
  std::uint16_t band_vertices = 0, band_instances = 1;
  Walker walker = Walker::both;  // whose pools there are
  // What there is no room for has no pools at all, not even a sink, and must not be drawn.
  bool exact = false;

  bool has(std::uint16_t room) const { return room != 0 || !exact; }

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

  const FrameStorage& storage() const { return storage_; }

  // Of all pools; the blocks hold no pointers, but for those of instances, so that they are as large on a board.
  std::size_t bytes() const { return bytes_; }

 private:
  template <typename T>
  Slice<T> take_items(std::uint32_t count);
  // A pool of so many blocks and their sink.
  template <typename T>
  PoolRef<T> take(std::uint16_t capacity);
  void take_segment_pools(std::uint16_t band_lines, const PoolSizes& sizes);
  void take_mesh_pools(std::uint16_t lines, const PoolSizes& sizes);
  void take_curve_pools(const Screen& screen, std::uint16_t band_lines, const PoolSizes& sizes);
  void take_points(const Screen& screen, std::uint16_t band_lines, const PoolSizes& sizes);

  std::vector<std::shared_ptr<void>> owned_;
  std::size_t bytes_ = 0;
  CurveOverlay overlay_;
  FrameStorage storage_{};
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
