// The body of a Frame with the edge walker alone; include it only where one with options of one's own is instantiated.
#pragma once

#include "core/frame/band_lines_impl.hpp"
#include "core/frame/mesh_frame.hpp"
#include "core/frame/mesh_lines_impl.hpp"
#include "core/frame/patch_lines_impl.hpp"

namespace spanline {

template <FrameOptions kOptions>
Band MeshFrame<kOptions>::prepare(const SceneView& scene, const CameraRecord& camera, Band rest) {
  if (rest.top == 0) status_ = {};
  band_ = {};
  if (refuses(camera, rest)) return band_;
  if (rest.top == 0) changes_.begin_frame(scene, camera);
  rest = changes_.next(rest);
  if (rest.empty()) return rest;
  if (note(begin(scene, camera, rest.top))) return band_;
  if constexpr (kOptions.plain) {
    painter_.begin_plain_lines(scene.scene().background.top);
  } else {
    note(curves_.begin(scene, camera, rest.top, rest.bottom));
    painter_.begin_lines(scene.scene().background);
  }
  return band_ = rest;
}

template <FrameOptions kOptions>
bool MeshFrame<kOptions>::refuses(const CameraRecord& camera, Band rest) {
  return note(check_band(rest, painter_.screen())) || note(check_camera(camera));
}

template <FrameOptions kOptions>
bool MeshFrame<kOptions>::next_line(Slice<std::uint8_t> out) {
  if (band_.empty()) return false;
  if (!takes_line(out, line_bytes())) return refuse(out);
  if constexpr (kOptions.plain) {
    painter_.begin_plain_line(band_.top, out.data());
  } else {
    painter_.begin_line(band_.top, out.data());
  }
  if (!mesh_.next(band_.top, painter_, tap())) return fall_short();
  if constexpr (!kOptions.plain) {
    if (const Status& drawn = curves_.draw(band_.top, painter_); !drawn.ok()) note(drawn);
  }
  if (status_.ok()) changes_.drawn(band_.top);
  ++band_.top;
  return true;
}

template <FrameOptions kOptions>
bool MeshFrame<kOptions>::end(const Status& status) {
  note(status);
  band_ = {};
  return false;
}

}  // namespace spanline
