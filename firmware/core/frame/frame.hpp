// A frame: a scene seen by a camera, made line by line; first its faces, then its curves over them in the order of
// their numbers. This is the engine's front door.
#pragma once

#include "core/curve/outline.hpp"
#include "core/frame/mesh_frame.hpp"

namespace spanline {

// The options that go with a budget: its walker, and patches and layers where there is room for them.
constexpr FrameOptions options_for(const Budget& budget) {
  const bool points = budget.point_lines != 0, patches = points || budget.patch_facets != 0 || budget.patch_grid != 0;
  const bool words = budget.walker == Walker::edges && !points && budget.format == PixelFormat::rgb565;
  return {.patches = patches,
          .points = points,
          .layers = budget.layers != 0,
          .walker = budget.walker,
          .bands = budget.band_vertices != 0,
          .changes = budget.kept_instances != 0,
          .paint = !words           ? Paint::any
                   : budget.gouraud ? Paint::smooth_words
                                    : Paint::flat_words,
          .plain = budget.plain && words && !patches && budget.kept_instances == 0};
}

template <FrameOptions kOptions = FrameOptions{}>
class Frame {
 public:
  // `storage` is used until the Frame is gone; nothing else may touch it meanwhile.
  explicit Frame(const FrameStorage& storage);
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  // Makes ready the longest run of lines from rest.top on whose waiting facets fit their pool, at most `rest`, and
  // returns it. Scene, and what its records point to, must stay as they are until the band is finished; between bands
  // of one frame too. A band that begins at line 0 begins a frame and clears status and statistics. Empty, with a
  // status, where rest or the camera is out of range, or the scene has patches, or is SceneView::layered(), and
  // FrameOptions::patches or layers is not set.
  //
  // With FrameOptions::changes only lines that may differ from the frame before are drawn (ChangedLines): the band
  // begins at the first of them, and with a status of ok an empty one means that there is none.
  Band prepare(const SceneView& scene, const CameraRecord& camera, Band rest);

  // Renders the next line of the band into `out`, in wire order. `out` must hold line_bytes() and begin on a 4-byte
  // boundary (else status bad_argument and false). False, and nothing written, when the band is finished.
  bool next_line(Slice<std::uint8_t> out);

  std::uint32_t line_bytes() const { return painter_.line_bytes(); }

  // Without FrameOptions::changes these say nothing. The next frame draws these lines, whatever has moved: the panel
  // does not show what it was sent.
  void redraw(Band lines) { changes_.redraw(lines); }
  // The next frame draws everything: meshes, materials or lights are not what they were.
  void forget() { changes_.forget(); }

  // Of the frame so far: what went wrong first. pool_exhausted means that a line needed more blocks than a pool has:
  // the picture then lacks the highest face numbers there, from that line to the end of its band, or the highest curve
  // numbers to their ends.
  const Status& status() const { return status_; }

  // Statistics where VsgOptions::statistics is set, NoStatistics otherwise.
  const auto& statistics() {
    auto& s = vsg_.statistics();
    if constexpr (kOptions.statistics) {
      s.bands = bands_;
      s.max_facets = most_facets_;
      s.max_vertices = vertices_;
      if constexpr (kOptions.points) {
        s.points_emitted = patches_.points();
      } else if constexpr (kDices) {
        s.max_patch_facets = patches_.most_facets();
        s.max_patch_vertices = patches_.most_vertices();
        s.points_emitted = patches_.points();
      }
    }
    return s;
  }
  void set_tap(const SpanTap& tap) { tap_ = tap; }

 private:
  static_assert(!kOptions.points || (kOptions.patches && !kOptions.layers),
                "points are of patches, and have no layers");
  static constexpr bool kDices = kOptions.patches && !kOptions.points;
  struct Sink;

  bool has_mesh_lines() const {
    if constexpr (kOptions.walker == Walker::both) return mesh_.ready();
    return false;
  }
  [[gnu::noinline]] void begin_curves(Band rest);  // keeps its registers off the stack of what comes after
  void read_vertices();
  FaceLook look_of(std::uint16_t face);
  bool mesh_line(std::uint16_t line);
  bool end_line();
  bool same_frame(const SceneView& scene, const CameraRecord& camera, Band rest) const;
  std::uint16_t plan(std::uint16_t top, std::uint16_t bottom);
  bool file_facets(std::uint16_t top, std::uint16_t bottom);
  bool file_facet(std::uint16_t face, std::uint16_t top, std::uint16_t bottom, std::uint16_t& count);
  // Templates, so that a frame without patches_ does not have them.
  template <typename Points>
  void plot_points(Points& points, std::uint16_t top, std::uint16_t bottom);
  template <typename Use>
  void each_patch(const Use& use);
  template <typename Patches>
  bool file_patches(Patches& patches, std::uint16_t top, std::uint16_t bottom, std::uint16_t& count);
  template <typename Patches>
  Room begin_patch_facet(const Patches& patches, std::uint16_t waiting, std::uint16_t line);
  template <typename Patches>
  bool shows_back(const Patches& patches, const DicedFacet& facet) const;
  bool is_plain(const MaterialRecord& material) const;
  bool wait(std::uint16_t face, std::int32_t first_line, std::uint16_t top, std::uint16_t& count);
  bool begin_facets(std::uint16_t line);
  Room begin_facet(std::uint16_t face, std::uint16_t line);
  typename VisibleSegments<kOptions>::Look layered(const FacetLook& look, const Rgb8& color,
                                                   const MaterialRecord& material) const;
  [[gnu::noinline]] Room begin_outline(std::uint16_t face, std::uint16_t line,
                                       const typename VisibleSegments<kOptions>::Look& look);
  const LightRig& lights() {
    return lights_.of(scene_.scene(), reader_.instance_index(), reader_.instance().transform);
  }
  // Whether there are points, and a band to plot them into.
  bool plots() const {
    if constexpr (kOptions.points) return scene_.has_patches() && patches_.lines() != 0;
    return false;
  }
  // Whether facets of patches are shaded from normals at their corners.
  template <typename Patches>
  bool keeps_normals(const Patches& patches, const MaterialRecord& material) const {
    return material.shading == MaterialRecord::kGouraud && vsg_.has_colours() && patches.has_normals();
  }
  // One line needs more of a pool than there is.
  void note_full(const char* pool, std::uint32_t needed, std::uint32_t limit, std::uint16_t line) {
    note({Code::pool_exhausted, pool, "", 0, line, needed, limit});
    if constexpr (kOptions.statistics) vsg_.statistics().facets_left_out += needed - limit;
  }
  void note(const Status& status) {
    if (status_.ok()) status_ = status;
  }

  Screen screen_;
  PoolRef<WaitingFacet> facets_;
  PoolRef<std::uint16_t> buckets_;
  PoolRef<ScreenPoint> cache_;
  using Lines = std::conditional_t<kDices, EdgeLines<kOptions.taps>, MeshLines<kOptions.taps>>;
  [[no_unique_address]] std::conditional_t<kOptions.walker == Walker::both, Lines, NoMeshLines> mesh_;
  SmoothCache smooth_;
  SceneView scene_;
  CameraRecord camera_{};
  FacetReader reader_;
  struct NoPatches {};
  using Drawn = std::conditional_t<kOptions.points, PointSource, PatchSource>;
  [[no_unique_address]] std::conditional_t<kOptions.patches, Drawn, NoPatches> patches_;
  KeptLights lights_;
  bool one_hue_ = true;  // LightHue::is_one()
  VisibleSegments<kOptions> vsg_;
  Painter painter_;
  CurveLayer curves_;
  [[no_unique_address]] SpanTap tap_;
  Status status_;
  Band band_;                         // the one that prepare() returned; top: the next line
  std::uint16_t planned_ = 0;         // end of the run of lines whose facets are filed
  std::uint16_t height_ = 0;          // lines of the run planned last
  std::uint16_t fitting_ = 0;         // lines of a run that fitted, where that was asked: where the next plan begins
  std::uint16_t polygons_filed_ = 0;  // of the facets filed; those of patches follow them, in patches_'s order
  std::uint16_t bands_ = 0, most_facets_ = 0, vertices_ = 0;
  [[no_unique_address]] std::conditional_t<kOptions.changes, ChangedLines, AllLines> changes_;
};

// With the edge walker alone.
template <FrameOptions kOptions>
requires(kOptions.walker == Walker::edges) class Frame<kOptions> : public MeshFrame<kOptions> {
 public:
  using MeshFrame<kOptions>::MeshFrame;
};

}  // namespace spanline
