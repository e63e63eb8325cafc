// The looks of the cells of grids (PatchGrids) that Gouraud's shading is used for.
#pragma once

#include "core/frame/patch_grids.hpp"
#include "core/frame/storage.hpp"
#include "core/shade/smooth_grid_walk.hpp"

namespace spanline {

class GridLooks {
 public:
  using Brush = GridBrush<GridVertex>;

  GridLooks() = default;
  explicit GridLooks(const FrameStorage& storage);

  // Finds out whether the scene's patches are smooth: all of them or none.
  Status begin_frame(const SceneView& scene);
  bool on() const { return on_; }
  const Brush* brush() const { return &brush_; }

  // All grids are new.
  void begin(PatchGrids& grids);
  void begin_line(std::uint16_t line, std::uint16_t background) { brush_.begin_line(line, background); }

  // The face's look, which the brush knows from then on. `reader` comes to the face's patch where materials differ.
  const FaceLook& learn(FaceId face, PatchGrids& grids, FacetReader& reader);
  // As Painter::smooth() and smooth_span() take them, of the look learned last.
  const std::uint16_t* colors() const { return brush_.colors(); }

 private:
  SmoothCache cache_;
  Brush brush_;
  const SceneRecord* scene_ = nullptr;
  std::uint16_t material_ = FaceLook::kNoMaterial;  // of all patches; kNoMaterial: they have several
  bool on_ = false;
};

// Where everything is flat.
struct NoGridLooks {
  NoGridLooks() = default;
  explicit NoGridLooks(const FrameStorage&) {}
  static Status begin_frame(const SceneView&) { return {}; }
  static constexpr bool on() { return false; }
  static const void* brush() { return nullptr; }
  static void begin(PatchGrids&) {}
  static void begin_line(std::uint16_t, std::uint16_t) {}
  static FaceLook learn(FaceId, PatchGrids&, FacetReader&) { return {}; }
  static const std::uint16_t* colors() { return nullptr; }
};

}  // namespace spanline
