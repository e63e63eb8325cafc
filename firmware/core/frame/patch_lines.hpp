// The lines of a frame of patches that the edge walker makes: the patches diced for the longest run of lines whose
// grids fit their pool, then line by line.
#pragma once

#include "core/frame/grid_looks.hpp"
#include "core/frame/mesh_lines.hpp"

namespace spanline {

template <bool kTaps, Paint kPaint = Paint::any>
class PatchLines {
 public:
  PatchLines() = default;
  explicit PatchLines(const FrameStorage& storage);

  // As MeshLines: scenes of patches alone, in the view whole, all smooth or none; culled ones not mirrored,
  // smooth ones culled.
  Status begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top);
  bool ready() const { return ready_; }
  const SceneRecord& scene() const { return scene_.scene(); }
  bool next(std::uint16_t line, Painter& painter, const SpanTap& tap);
  const Status& shortage() const { return shortage_; }

  // Of the frame so far: Budget::edges and patch_grid, runs of lines.
  void count(Statistics& s) const {
    s.max_edges = most_edges_;
    s.max_patch_grid = grids_.most();
    s.bands = runs_;
  }

 private:
  struct Sink;
  struct Planes;

  // Whether lines are of RGB565, that fill_span() and smooth_span() can fill.
  bool words() const { return kPaint != Paint::any || screen_.format == PixelFormat::rgb565; }
  bool give_up(const Status& status);

  Status check() const;
  Status plan(std::uint16_t top);
  Status dice_all();
  Status dice(std::uint16_t face, const LightRig& rig, const FacetLight& light);
  bool start_edges(std::uint16_t line, std::uint16_t vertex);
  bool run_again(ActiveEdge& edge, std::int32_t line);

  SceneView scene_;
  CameraRecord camera_{};
  Screen screen_;
  [[no_unique_address]] std::conditional_t<kPaint == Paint::flat_words, NoGridLooks, GridLooks> looks_;
  PoolRef<std::uint16_t> buckets_;
  FacetReader reader_;
  PatchGrids grids_;
  EdgeWalker walker_;
  std::uint16_t line_ = 0;    // to be made next
  std::uint16_t top_ = 0;     // of the run planned last
  std::uint16_t height_ = 0;  // lines of it; 0: none was planned
  std::uint16_t runs_ = 0;
  std::uint32_t most_edges_ = 0;
  Status shortage_;
  bool both_sides_ = false;   // of some patch are drawn
  bool planes_made_ = false;  // on the line
  bool ready_ = false;
};

}  // namespace spanline
