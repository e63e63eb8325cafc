// The lines of a frame that the edge walker makes: vertices projected once, faces culled and lit once, then line by
// line.
#pragma once

#include "core/frame/depth_rows.hpp"
#include "core/frame/storage.hpp"
#include "core/geom/camera.hpp"
#include "core/shade/light.hpp"
#include "core/shade/painter.hpp"
#include "core/shade/smooth_brush.hpp"
#include "core/vsg/mesh_walker.hpp"
#include "core/vsg/statistics.hpp"

namespace spanline {

// Sees every visible span before it is painted; for tools (VsgOptions::taps). A line that the edge walker gives up is
// seen again from its left end.
struct SpanTap {
  void* context = nullptr;
  void (*span)(void* context, const VisibleSpan& span) = nullptr;
  void (*layers)(void* context, const LayeredSpan& span) = nullptr;

  // Tells of a span of the edge walker.
  void tell(std::uint16_t line, std::int32_t left, std::int32_t right, std::uint16_t face, std::uint16_t payload,
            const DepthRamp& depth) const {
    if (span == nullptr) return;
    VisibleSpan seen;
    seen.line = line;
    seen.left = static_cast<std::uint16_t>(left);
    seen.right = static_cast<std::uint16_t>(right);
    seen.face = face;
    seen.payload = payload;
    seen.depth = depth;
    span(context, seen);
  }
};

// The word of a face: the colour it is painted in, or the one value that means that it is not drawn. That value is no
// drawn face's colour: where one turns out to have it, another takes its place. Faces that are not set keep their
// words.
class FaceWords {
 public:
  FaceWords() = default;
  constexpr explicit FaceWords(PoolRef<std::uint16_t> words) : words_(words) {}

  std::uint16_t capacity() const { return words_.capacity(); }
  std::uint16_t& operator[](FaceId face) { return words_[face]; }
  DrawnFaces<std::uint16_t> drawn() const { return {&words_[0], not_drawn_}; }

  // Says of faces one after another, from `first` on, whether they are drawn, but not yet in which colour.
  class Culled {
   public:
    Culled(FaceWords& words, FaceId first)
        : next_(&words.words_[first]), not_drawn_(words.not_drawn_), drawn_(words.some_drawn()) {}
    void hide() { *next_++ = not_drawn_; }
    void show() { *next_++ = drawn_; }

   private:
    std::uint16_t* next_;
    std::uint16_t not_drawn_, drawn_;
  };
  Culled cull(FaceId first) { return {*this, first}; }
  // Gives those of `count` faces that are drawn their colours, color_of(0 … count - 1).
  template <typename ColorOf>
  void color(FaceId first, std::uint32_t count, const ColorOf& color_of) {
    std::uint16_t* const words = &words_[first];
    std::uint16_t not_drawn = not_drawn_;
    for (std::uint32_t i = 0; i != count; ++i) {
      if (words[i] == not_drawn) continue;
      const std::uint16_t color = color_of(i);
      if (color == not_drawn) [[unlikely]]
        not_drawn = avoid();
      words[i] = color;
    }
  }

 private:
  std::uint16_t some_drawn() const { return static_cast<std::uint16_t>(~not_drawn_); }
  std::uint16_t avoid();

  PoolRef<std::uint16_t> words_;
  std::uint16_t not_drawn_ = 0x2008;
};

// Of each face the number of its look (SmoothCache), which may be another face's by now, or that it is not drawn.
class FaceSlots {
 public:
  FaceSlots() = default;
  constexpr explicit FaceSlots(PoolRef<std::uint8_t> slots) : slots_(slots) {}

  std::uint16_t capacity() const { return slots_.capacity(); }
  std::uint8_t& operator[](FaceId face) { return slots_[face]; }
  DrawnFaces<std::uint8_t> drawn() const { return {&slots_[0], kHidden}; }

  // As FaceWords::Culled; a face that is shown has no look yet.
  class Culled {
   public:
    explicit Culled(std::uint8_t* first) : next_(first) {}
    void hide() { *next_++ = kHidden; }
    void show() { *next_++ = 0; }

   private:
    std::uint8_t* next_;
  };
  Culled cull(FaceId first) { return Culled(&slots_[first]); }

 private:
  static constexpr std::uint8_t kHidden = 0xff;
  static_assert(kHidden > SmoothCache::kMostLooks);

  PoolRef<std::uint8_t> slots_;
};

// The faces of a group whose material is Gouraud's, the last that a look was made of.
struct SmoothFaces {
  FaceId first = 0;
  std::uint16_t count = 0;
  std::uint16_t material = 0;
  const std::uint16_t* corners = nullptr;  // of the first
  const ScreenXY* points = nullptr;        // by what corners say
  const Brightness* levels = nullptr;      // likewise
};

// Which material a group of faces has in an instance.
inline std::uint16_t material_of(const InstanceRecord& instance, const FaceGroup& group) {
  return instance.material == InstanceRecord::kOwnMaterials ? group.material : instance.material;
}
// What the edge walker cannot draw of a scene of meshes;
Status check_meshes(const SceneView& scene);
// nor where Gouraud's materials are drawn as such.
Status check_smooth(const SceneRecord& scene);
// Where project() fails.
Status beyond_view(std::uint32_t instance);
// What a line lacked that was not walked whole.
Status walker_shortage(const EdgeWalker& walker, bool overlaps, std::uint16_t line);

template <bool kTaps, Paint kPaint = Paint::any, bool kPlain = false>
class MeshLines {
 public:
  MeshLines() = default;
  constexpr MeshLines(const FrameStorage& storage)
      : screen_(storage.screen),
        points_(storage.mesh.walker.points),
        levels_(storage.mesh.levels),
        smooth_(storage.smooth, storage.screen.format),
        words_(storage.mesh.faces),
        slots_(storage.mesh.slots),
        walker_(storage.mesh.walker, storage.screen) {
    if constexpr (kPaint == Paint::any) {
      if (storage.screen.format == PixelFormat::rgb565) found_ = smooth() ? Paint::smooth_words : Paint::flat_words;
    }
    points_.limit(VertexBuckets::kMostVertices);
  }

  // Makes ready the lines from `top` on; costs nothing where they follow the line made last. Fails where the edge
  // walker cannot draw the scene: the status says which record, or which pool is too small. What has not moved by
  // `changes` (ChangedLines, AllLines) is neither projected nor lit again.
  template <typename Changes>
  Status begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top, Changes& changes);
  bool ready() const { return ready_; }
  void count(Statistics& s) const { s.max_edges = walker_.most_edges(); }  // see Budget::edges
  const SceneRecord& scene() const { return scene_.scene(); }

  // Renders the line after the last, where ready. False where a pool is too small, and it is not ready any more; what
  // has been painted of the line has to be painted again.
  bool next(std::uint16_t line, Painter& painter, const SpanTap& tap);
  // What next() failed for: pool_exhausted.
  Status shortage() const;

 private:
  struct Sink;
  struct Planes;

  [[gnu::noinline]] Status take(const SceneView& scene, const CameraRecord& camera);
  bool goes_on(const SceneView& scene, const CameraRecord& camera, std::uint16_t top) const;
  [[gnu::noinline]] void clear(std::uint16_t top, std::int32_t farthest);
  Paint paint() const { return kPaint == Paint::any ? found_ : kPaint; }
  PixelFormat format() const { return kPaint == Paint::any ? screen_.format : PixelFormat::rgb565; }
  constexpr bool smooth() const { return kPaint == Paint::any ? smooth_.on() : kPaint == Paint::smooth_words; }
  static void learn_look(void* self, FaceId face);
  void make_look(FaceId face, FaceLook& look);
  bool turn_to(FaceId face, FaceLook& flat);
  using Lights = std::conditional_t<kPlain, PlainLight, LightRig>;
  const Lights& lights(const InstanceCursor& at) {
    return lights_.of(scene_.scene(), at.index(), at.instance().transform);
  }
  [[gnu::noinline]] void dip(std::uint16_t material) {
    brush_.dip(material, smooth_.template colors<kPlain>(material, scene_.scene()));
  }
  std::uint16_t flat_color(const InstanceCursor& at, std::uint32_t mesh_face, const MaterialRecord& material);
  bool give_up(bool overlaps);
  bool project(const InstanceCursor& at);
  void cull(const InstanceCursor& at);
  template <typename Culled>
  void cull(const InstanceCursor& at, Culled faces);
  void light_faces(const InstanceCursor& at);
  void light_vertices(const InstanceCursor& at);

  SceneView scene_;
  CameraRecord camera_{};
  Screen screen_;
  PoolRef<ScreenXY> points_;
  PoolRef<Brightness> levels_;
  SmoothCache smooth_;
  SmoothBrush brush_;
  FaceWords words_;
  FaceSlots slots_;  // in their place where faces may be smooth
  DepthRows rows_;
  SmoothFaces smooth_faces_;
  Kept<Lights> lights_;
  MeshWalker walker_;
  Paint found_ = Paint::any;  // where it is not decided beforehand
  std::uint16_t line_ = 0;    // to be made next
  bool ready_ = false, overlaps_short_ = false;
};

// Where there is no edge walker.
struct NoMeshLines {
  explicit NoMeshLines(const FrameStorage&) {}
};

}  // namespace spanline
