#pragma once

#include "core/frame/band_lines.hpp"
#include "core/frame/edge_lines.hpp"
#include "core/vsg/statistics.hpp"

namespace spanline {

Status check_band(Band rest, const Screen& screen);
// Whether a line of `bytes` can be rendered into `out`, and the status where it cannot.
inline bool takes_line(Slice<std::uint8_t> out, std::uint32_t bytes) {
  return out.size() >= bytes && reinterpret_cast<std::uintptr_t>(out.data()) % 4 == 0;
}
Status line_refused(Slice<std::uint8_t> out, std::uint32_t bytes, std::uint32_t line);

// What a Frame is with the edge walker alone, for meshes (MeshLines) or for patches: to be used as every Frame. Scenes
// that the walker cannot draw are refused by prepare() with the status of MeshLines::begin(); a line for which a pool
// is too small ends the band, and status() names the pool. prepare() returns all of `rest`, or of what has changed in
// it the first run of lines.
template <typename Lines, bool kStatistics, bool kChanges>
class MeshFrame {
 public:
  explicit MeshFrame(const FrameStorage& storage)
      : screen_(storage.screen),
        mesh_(storage),
        painter_(storage.screen),
        curves_(storage.curves, storage.screen),
        changes_(storage.changes, storage.screen) {}
  MeshFrame(const MeshFrame&) = delete;
  MeshFrame& operator=(const MeshFrame&) = delete;

  Band prepare(const SceneView& scene, const CameraRecord& camera, Band rest);
  bool next_line(Slice<std::uint8_t> out);
  std::uint32_t line_bytes() const { return painter_.line_bytes(); }
  void redraw(Band lines) { changes_.redraw(lines); }
  void forget() { changes_.forget(); }
  const Status& status() const { return status_; }
  // What Lines count.
  Counters<kStatistics> statistics() const {
    Counters<kStatistics> s;
    if constexpr (kStatistics) mesh_.count(s);
    return s;
  }
  void set_tap(const SpanTap& tap) { tap_ = tap; }

 private:
  Status begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top) {
    if constexpr (requires { mesh_.begin(scene, camera, top, changes_); }) {
      return mesh_.begin(scene, camera, top, changes_);
    } else {
      return mesh_.begin(scene, camera, top);
    }
  }
  [[gnu::noinline]] bool end(const Status& status);
  // Apart, so that a line that comes out well has no room for a Status on its stack.
  [[gnu::noinline]] bool refuse(Slice<std::uint8_t> out) { return end(line_refused(out, line_bytes(), band_.top)); }
  [[gnu::noinline]] bool fall_short() { return end(mesh_.shortage()); }
  void note(const Status& status) {
    if (status_.ok()) status_ = status;
  }

  Screen screen_;
  Lines mesh_;
  Painter painter_;
  CurveLayer curves_;
  [[no_unique_address]] SpanTap tap_;
  Status status_;
  Band band_;
  [[no_unique_address]] std::conditional_t<kChanges, ChangedLines, AllLines> changes_;
};

template <typename Lines, bool kStatistics, bool kChanges>
Band MeshFrame<Lines, kStatistics, kChanges>::prepare(const SceneView& scene, const CameraRecord& camera, Band rest) {
  if (rest.top == 0) status_ = {};
  band_ = {};
  Status status = check_band(rest, screen_);
  if (status.ok()) status = check_camera(camera);
  if (status.ok()) {
    if (rest.top == 0) changes_.begin_frame(scene, camera);
    rest = changes_.next(rest);
    if (rest.empty()) return rest;
    status = begin(scene, camera, rest.top);
  }
  if (status.ok()) {
    status = curves_.begin(scene, camera, rest.top, rest.bottom);
    painter_.begin_lines(scene.scene().background);
    band_ = rest;
  }
  if (!status.ok()) note(status);
  return band_;
}

template <typename Lines, bool kStatistics, bool kChanges>
bool MeshFrame<Lines, kStatistics, kChanges>::next_line(Slice<std::uint8_t> out) {
  if (band_.empty()) return false;
  if (!takes_line(out, line_bytes())) return refuse(out);
  painter_.begin_line(band_.top, out.data());
  if (!mesh_.next(band_.top, painter_, tap_)) return fall_short();
  if (const Status& drawn = curves_.draw(band_.top, painter_); !drawn.ok()) note(drawn);
  if (status_.ok()) changes_.drawn(band_.top);
  ++band_.top;
  return true;
}

template <typename Lines, bool kStatistics, bool kChanges>
bool MeshFrame<Lines, kStatistics, kChanges>::end(const Status& status) {
  note(status);
  band_ = {};
  return false;
}

}  // namespace spanline
