#pragma once

#include "core/frame/band_lines.hpp"
#include "core/frame/edge_lines.hpp"
#include "core/vsg/statistics.hpp"

namespace spanline {

using FrameOptions = VsgOptions;

Status check_band(Band rest, const Screen& screen);
// Whether a line of `bytes` can be rendered into `out`, and the status where it cannot.
inline bool takes_line(Slice<std::uint8_t> out, std::uint32_t bytes) {
  return out.size() >= bytes && reinterpret_cast<std::uintptr_t>(out.data()) % 4 == 0;
}
Status line_refused(Slice<std::uint8_t> out, std::uint32_t bytes, std::uint32_t line);

// What the edge walker makes lines of: with FrameOptions::patches scenes of patches, else of meshes.
template <FrameOptions kOptions>
using MeshesOf = std::conditional_t<kOptions.bands, BandLines<kOptions.taps, kOptions.paint, kOptions.plain>,
                                    MeshLines<kOptions.taps, kOptions.paint, kOptions.plain>>;
template <FrameOptions kOptions>
using LinesOf = std::conditional_t<kOptions.patches, PatchLines<kOptions.taps, kOptions.paint>, MeshesOf<kOptions>>;

// What a Frame is with the edge walker alone: to be used as every Frame. Scenes
// that the walker cannot draw are refused by prepare() with the status of MeshLines::begin(); a line for which a pool
// is too small ends the band, and status() names the pool. prepare() returns all of `rest`, or of what has changed in
// it the first run of lines.
template <FrameOptions kOptions>
class MeshFrame {
  static_assert(!kOptions.plain || (kOptions.paint != Paint::any && !kOptions.patches));

 public:
  constexpr explicit MeshFrame(const FrameStorage& storage)
      : mesh_(storage),
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
  Counters<kOptions.statistics> statistics() const {
    Counters<kOptions.statistics> s;
    if constexpr (kOptions.statistics) mesh_.count(s);
    return s;
  }
  void set_tap(const SpanTap& tap) {
    if constexpr (kOptions.taps) tap_ = tap;
  }

 private:
  Status begin(const SceneView& scene, const CameraRecord& camera, std::uint16_t top) {
    if constexpr (requires { mesh_.begin(scene, camera, top, changes_); }) {
      return mesh_.begin(scene, camera, top, changes_);
    } else {
      return mesh_.begin(scene, camera, top);
    }
  }
  const SpanTap& tap() const {
    static constexpr SpanTap kNone{};
    if constexpr (kOptions.taps) {
      return tap_;
    } else {
      return kNone;
    }
  }
  // Apart, likewise.
  [[gnu::noinline]] bool refuses(const CameraRecord& camera, Band rest);
  [[gnu::noinline]] bool end(const Status& status);
  // Apart, so that a line that comes out well has no room for a Status on its stack.
  [[gnu::noinline]] bool refuse(Slice<std::uint8_t> out) { return end(line_refused(out, line_bytes(), band_.top)); }
  [[gnu::noinline]] bool fall_short() { return end(mesh_.shortage()); }
  // Whether it is a fault, of which the first is kept.
  [[gnu::noinline]] bool note(const Status& status) {
    if (status_.ok()) status_ = status;
    return !status.ok();
  }

  struct NoTap {};

  LinesOf<kOptions> mesh_;
  Painter painter_;
  [[no_unique_address]] std::conditional_t<kOptions.plain, NoCurveLayer, CurveLayer> curves_;
  [[no_unique_address]] std::conditional_t<kOptions.taps, SpanTap, NoTap> tap_;
  Status status_;
  Band band_;
  [[no_unique_address]] std::conditional_t<kOptions.changes, ChangedLines, AllLines> changes_;
};

}  // namespace spanline
