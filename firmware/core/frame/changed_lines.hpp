// Which lines of a frame may differ from the frame before: those that an instance lies on that has moved, or lay on. A
// line's pixels come of the instances on it, the camera and the background alone, whatever the bands; so the others
// need not be drawn again where the panel keeps what it was sent.
#pragma once

#include "core/base/slice.hpp"
#include "core/frame/band.hpp"
#include "core/geom/screen.hpp"
#include "core/scene/scene_view.hpp"

namespace spanline {

// An instance as it was drawn last, and what its mesh's shape comes to.
struct KeptInstance {
  InstanceRecord record;
  std::int16_t low[3], high[3];  // all positions lie between, both included
  std::uint16_t stroke;          // 1/16 px: half the widest curve
  bool beyond_hull;              // has curves that leave the hull of their points
  bool moved;                    // since its geometry was kept
  Band lines;                    // it lies on no other
};
static_assert(sizeof(KeptInstance) == 76);

struct ChangesStorage {
  Slice<KeptInstance> instances;
  Slice<std::uint32_t> lines;  // a bit each
};

class ChangedLines {
 public:
  // All lines are to be drawn. `storage` is used until the ChangedLines is gone.
  ChangedLines(const ChangesStorage& storage, const Screen& screen);

  // Compares the frame to come with the one before. Meshes, materials and lights are taken to be what they were while
  // `scene` is at the same place: say forget() where they change. With more instances than there is storage for every
  // line changes.
  void begin_frame(const SceneView& scene, const CameraRecord& camera);

  // The first run of lines within `rest` to be drawn; so are a few in between that need not be, where that is sooner
  // done than to begin another. Empty where there is none.
  Band next(Band rest) const;
  // What the panel is sent of a line is now what the frame shows.
  void drawn(std::uint16_t line) { lines_[line / 32] &= ~(1u << line % 32); }
  // These lines are to be drawn, whatever has moved.
  void redraw(Band lines);
  // The next frame is compared with none.
  void forget() { keeps_ = false; }

  static constexpr bool kKeepsGeometry = true;
  // Whether an instance has moved, or the camera has, since geometry_kept() was last said; whether nothing has.
  bool moved(std::uint32_t instance) const { return !keeps_ || instances_[instance].moved; }
  bool still() const { return still_; }
  void geometry_kept();

 private:
  // So few lines cost less than another band.
  static constexpr std::uint16_t kWorthABand = 8;

  void keep(const SceneRecord& scene, std::uint32_t instance, const CameraRecord& camera, bool known);
  Band lines_of(const KeptInstance& kept, const MeshRecord& mesh, const CameraRecord& camera) const;
  bool is_changed(std::uint32_t line) const { return (lines_[line / 32] >> line % 32 & 1u) != 0; }

  Slice<KeptInstance> instances_;
  Slice<std::uint32_t> lines_;
  Screen screen_;
  const SceneRecord* scene_ = nullptr;
  std::uint32_t count_ = 0;
  bool keeps_ = false, still_ = false;
  CameraRecord camera_{};
  BackgroundRecord background_{};
};

// Where every line is drawn in every frame.
struct AllLines {
  static constexpr bool kKeepsGeometry = false;
  constexpr AllLines(const ChangesStorage&, const Screen&) {}
  void begin_frame(const SceneView&, const CameraRecord&) {}
  Band next(Band rest) const { return rest; }
  void drawn(std::uint16_t) {}
  void redraw(Band) {}
  void forget() {}
  bool moved(std::uint32_t) const { return true; }
  bool still() const { return true; }
  void geometry_kept() {}
};

}  // namespace spanline
