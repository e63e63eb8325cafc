// The lines of a frame of meshes in little memory: of each face and each vertex a bit is kept, and of the vertices
// those whose first line lies in a band. All else is made when it is needed and forgotten.
#pragma once

#include "core/frame/instance_points.hpp"
#include "core/frame/mesh_lines.hpp"

namespace spanline {

template <bool kTaps, Paint kPaint, bool kPlain = false>
class BandLines {
 public:
  explicit BandLines(const FrameStorage& storage);

  // As MeshLines: the same scenes, the same pictures. Where an edge, or a line's faces, have no room the status is the
  // same, too; vertices always have.
  template <typename Changes>
  Status begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top, Changes& changes);
  bool next(std::uint16_t line, Painter& painter, const SpanTap& tap);
  Status shortage() const;

  // Of the frame so far: Budget::edges, bands.
  void count(Statistics& s) const {
    s.max_edges = walker_.most_edges();
    s.bands = bands_;
  }

 private:
  struct Sink;
  struct Planes;

  [[gnu::noinline]] Status check(const SceneView& scene) const;
  [[gnu::noinline]] void clear(const SceneView& scene, const CameraRecord& camera, std::uint16_t top);
  void begin_lines(std::uint16_t top);
  [[gnu::noinline]] bool cull(bool surely);
  bool cull_placed(bool surely);
  bool cull_by_places(bool surely);
  template <typename Place>
  void cull_by(const Place& place);
  [[gnu::noinline]] void plan(std::uint16_t top);
  // A vertex of the scene; its instance becomes that of `points_`.
  ScreenXY project(std::uint32_t vertex) {
    points_.to_vertex(vertex);
    return points_[vertex - points_.first_vertex()];
  }
  [[gnu::noinline]] bool start_edges(std::int32_t line);
  [[gnu::noinline]] bool start_fans(BandStart& start, std::uint32_t first);
  [[gnu::cold, gnu::noinline]] bool start_crowded_line(BandStart& start);
  [[gnu::cold]] bool start_crowded(BandStart& start);
  bool run_again(ActiveEdge& edge, std::int32_t line);
  [[gnu::noinline]] DepthPlane plane(FaceId face);
  void corners(FaceId face, ScreenXY (&at)[3]);
  // A vertex of the mesh of `points_` on the screen.
  ScreenXY place(std::uint32_t vertex) {
    const BandVertex* const kept = vertices_.find(points_.first_vertex() + vertex);
    return kept != nullptr ? kept->at : points_[vertex];
  }

  const Screen& screen() const { return walker_.screen(); }
  Paint paint() const { return kPaint == Paint::any ? found_ : kPaint; }
  // What faces look like: of what the lines are painted with only that is there.
  struct Looks {
    SmoothCache cache;
    LookChains chains;
    BandBrush brush;
    bool on() const { return cache.on(); }
  };
  struct NoLooks {
    static constexpr bool on() { return false; }
  };
  struct NoColors {
    NoColors(PoolRef<FaceColor>, FaceColors::Learn, void*) {}
    void clear() {}
    void put(FaceId, std::uint16_t) {}
    std::uint16_t operator[](FaceId) const { return 0; }
  };
  static constexpr bool kSmooths = kPaint != Paint::flat_words, kFlats = kPaint != Paint::smooth_words;
  bool smooth() const { return kPaint == Paint::any ? looks_.on() : kSmooths; }
  void begin_line(std::uint16_t line, std::uint16_t background) {
    if constexpr (kSmooths) {
      if (smooth()) {
        looks_.brush.begin_line(line);
        if (background != background_) looks_.chains.put(FaceLook::flat(background));
        background_ = background;
        return;
      }
    }
    background_ = background;
    colors_.put(0, background);
  }
  // Of a face, where all are flat; for colors_.
  static std::uint16_t learn_color(void* self, FaceId face);
  // Templates, so that a frame without looks does not have them.
  template <typename AnyLooks>
  const std::uint16_t* colors_of(AnyLooks& looks, std::uint16_t material) {
    return looks.cache.template colors<kPlain>(material, points_.scene());
  }
  // For the brush.
  template <typename AnyLooks>
  static void learn_look(void* self, FaceId face);
  template <typename AnyLooks>
  [[gnu::noinline]] void make_look(AnyLooks& looks, FaceId face, FaceLook& look);
  std::uint16_t flat_color(FaceId face);
  void bring_to_hand(FaceId face) {
    if (std::uint32_t{face} - at_hand_.first >= at_hand_.count) [[unlikely]]
      turn_to(face);
  }
  [[gnu::noinline]] void turn_to(FaceId face);
  // As the instance of `points_` sees them.
  using Lights = std::conditional_t<kPlain, PlainLight, LightRig>;
  const Lights& lights() { return lights_.of(points_.scene(), points_.index(), points_.instance().transform); }
  bool give_up(bool overlaps);

  InstancePoints points_;
  BandVertices vertices_;
  PoolRef<ScreenXY> culled_;  // of a mesh, while its faces are culled
  BitPool drawn_;             // faces that are seen from their fronts
  [[no_unique_address]] std::conditional_t<kFlats, FaceColors, NoColors> colors_;
  [[no_unique_address]] std::conditional_t<kSmooths, Looks, NoLooks> looks_;
  Kept<Lights> lights_;
  // The group of a face that was lit last.
  struct {
    std::uint32_t before = 0;  // the id of its mesh's first face
    std::uint32_t first = 0;   // id
    std::uint16_t count = 0;   // of faces
    std::uint16_t material = 0;
    const MaterialRecord* look = nullptr;
    // Where one light tells how they look, that of lights_: the normals, of flat ones by ids, where it has no hue
    // either.
    const Normal10* normals = nullptr;
  } at_hand_;
  EdgeWalker walker_;
  std::int32_t background_ = 0;  // of the line, if it has begun in this frame, else below 0
  std::uint16_t line_ = 0;       // to be made next
  std::uint16_t end_ = 0;        // of the band
  std::uint16_t bands_ = 0;
  Paint found_ = Paint::any;
  bool crowded_ = false;  // the band is a line whose vertices are too many to be kept
  bool ready_ = false, overlaps_short_ = false;
};

}  // namespace spanline
