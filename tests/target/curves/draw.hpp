// Pictures of what is curved: isocurves, strokes, filled outlines, and patches by the edge walker; with the CRC-32 of
// their line bytes, the same on the host and on every core.
#pragma once

#include <cstddef>
#include <new>

#include "boards/common/frame_marks.hpp"
#include "core/frame/frame.hpp"
#include "dial.hpp"
#include "glyphs.hpp"
#include "golden/crc32.hpp"
#include "patches.hpp"
#include "patches_both_sides.hpp"
#include "smooth_patches.hpp"
#include "wire.hpp"

namespace spanline::target {

struct CurvedPicture {
  const char* name;
  const SceneRecord* scene;
  const CameraRecord* camera;
  std::uint32_t crc;
};

inline constexpr CurvedPicture kCurves[] = {
    {"wire", &wire::scene, &wire::camera, 0xdadaa60f},
    {"dial", &dial::scene, &dial::camera, 0xeb211d94},
    {"glyphs", &glyphs::scene, &glyphs::camera, 0x697c932f},
};
inline constexpr CurvedPicture kPatches[] = {
    {"patches", &patches::scene, &patches::camera, 0x9bfee82f},
    {"patches from both sides", &patches_both_sides::scene, &patches_both_sides::camera, 0x24da16e2},
};
inline constexpr CurvedPicture kSmoothPatches[] = {
    {"smooth patches", &smooth_patches::scene, &smooth_patches::camera, 0xda5dbc3f}};

// Each holds all of its pictures.
inline constexpr Budget kCurvesBudget{.facets = 16,
                                      .vertices = 300,
                                      .polygons = 16,
                                      .edges = 112,
                                      .segments = 40,
                                      .curves = 240,
                                      .strands = 160,
                                      .gouraud = false};
inline constexpr Budget kPatchesBudget{
    .facets = 0, .vertices = 0, .edges = 120, .patch_grid = 1380, .gouraud = false, .walker = Walker::edges};
inline constexpr Budget kSmoothPatchesBudget{
    .facets = 0, .vertices = 0, .edges = 73, .patch_grid = 1380, .walker = Walker::edges, .looks = 110};

struct Drawn {
  Status status;
  std::uint32_t crc;
};

// One after the other takes it.
inline void* room() {
  constexpr std::size_t kForCurves = sizeof(FrameMemory<kCurvesBudget>), kForFlat = sizeof(FrameMemory<kPatchesBudget>),
                        kForSmooth = sizeof(FrameMemory<kSmoothPatchesBudget>);
  static_assert(kForFlat < kForSmooth);
  alignas(std::max_align_t) static std::byte bytes[kForCurves > kForSmooth ? kForCurves : kForSmooth];
  return bytes;
}

template <Budget kBudget>
Drawn draw(const CurvedPicture& picture) {
  auto& memory = *new (room()) FrameMemory<kBudget>;
  alignas(4) static std::uint8_t line[bytes_per_line(kBudget.format, kBudget.width)];
  SceneView scene;
  const Status status = SceneView::validate(*picture.scene, scene);
  if (!status.ok()) return {status, 0};
  Frame<options_for(kBudget)> frame(memory.storage());
  golden::Crc32 sum;
  frame_begin_mark();
  for (Band rest{0, kBudget.height}; !rest.empty();) {
    const Band band = frame.prepare(scene, *picture.camera, rest);
    if (band.empty()) break;
    while (frame.next_line(line)) sum.add(line);
    rest.top = band.bottom;
  }
  frame_end_mark();
  return {frame.status(), sum.value()};
}

// tell(picture, what it came to) for every picture.
template <typename Tell>
void draw_all(const Tell& tell) {
  for (const CurvedPicture& picture : kCurves) tell(picture, draw<kCurvesBudget>(picture));
  for (const CurvedPicture& picture : kPatches) tell(picture, draw<kPatchesBudget>(picture));
  for (const CurvedPicture& picture : kSmoothPatches) tell(picture, draw<kSmoothPatchesBudget>(picture));
}

}  // namespace spanline::target
