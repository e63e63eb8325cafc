// Demos: board-independent scenes that move. Tables in flash (made by `spanline assets`), poses by integer arithmetic
// from the frame number alone, so frame k is the same picture on every core and on the host.
//
//   constexpr Screen kScreen{320, 240, PixelFormat::rgb565};
//   constexpr demos::Demo kDemo = demos::chosen(kScreen);     // demos/chosen.hpp; SPANLINE_DEMO=teapot at build time
//   FrameMemory<demos::budget_for(kDemo, kScreen)> memory;
//   demos::Stage stage;                                       // in RAM, for as long as frames are drawn
//   Status status = stage.begin(kDemo, kScreen);              // once
//   stage.show(k);                                            // before frame k: never while a frame is being drawn
//   frame.prepare(stage.view(), stage.camera(), rest);
#pragma once

#include <cstdint>

#include "core/frame/budget.hpp"
#include "core/geom/screen.hpp"
#include "core/scene/scene_view.hpp"

namespace spanline::demos {

inline constexpr std::uint32_t kMaxInstances = 12;

// What a pose may change: the scene's own records in the beginning of each frame.
struct Moving {
  Slice<InstanceRecord> instances;
  CameraRecord& camera;
};

// A compiled scene as it is seen.
struct Shot {
  const SceneRecord* scene;
  const CameraRecord* camera;
  const Fx16 (*target)[3];      // world, what the camera looks at
  const Fx16 (*origins)[3];     // of each mesh its own origin, as MeshRecord::origin
  std::uint16_t width, height;  // px, the picture that `camera` was made for: every screen shows at least that
};

// One demo laid out for one shape of screen.
struct Demo {
  const char* name;
  void (*pose)(std::uint32_t frame, const Shot& shot, const Moving& moving);
  Shot shot;
  Budget budget;  // its pools; the screen's fields are not used
};

// A demo with its layouts.
struct Layouts {
  struct Layout {
    Shot shot;
    Budget budget;
  };
  static constexpr std::uint16_t kSmallHeight = 128;  // px

  const char* name;
  void (*pose)(std::uint32_t frame, const Shot& shot, const Moving& moving);
  Layout wide;    // wider than high
  Layout tall;    // higher than wide
  Layout square;  // as wide as high, and within the circle of a round glass
  Layout small;   // fewer than kSmallHeight lines: closer, simpler, more contrast

  constexpr Demo framed_for(const Screen& screen) const {
    const Layout& layout = layout_for(screen);
    return {name, pose, layout.shot, layout.budget};
  }

 private:
  constexpr const Layout& layout_for(const Screen& screen) const {
    if (screen.height < kSmallHeight) return small;
    if (screen.height == screen.width) return square;
    return screen.height > screen.width ? tall : wide;
  }
};

// The memory that a demo needs on a screen.
constexpr Budget budget_for(const Demo& demo, const Screen& screen) {
  Budget budget = demo.budget;
  budget.width = screen.width;
  budget.height = screen.height;
  budget.format = screen.format;
  return budget;
}

// A demo on the stage: the records that move. About 850 bytes.
class Stage {
 public:
  Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  // Puts on `demo`, which is copied, framed for `screen`, and shows frame 0. Fails as SceneView::validate does, or with
  // bad_record ("instances") where the scene has more than kMaxInstances.
  Status begin(const Demo& demo, const Screen& screen);

  // Moves everything to where it is in frame `frame`; any order of frames will do.
  void show(std::uint32_t frame);

  const SceneView& view() const { return view_; }
  const CameraRecord& camera() const { return camera_; }

 private:
  Demo demo_{};
  Fx12 focal_;  // px on this screen
  InstanceRecord instances_[kMaxInstances]{};
  SceneRecord scene_{};
  SceneView view_;
  CameraRecord camera_{};
};

}  // namespace spanline::demos
