// The faces that the engine shows of a scene, by each of its ways to find them, as a checksum: the same on the target
// and on the host.
#pragma once

#include "boards/common/frame_marks.hpp"
#include "core/frame/frame_impl.hpp"
#include "golden/crc32.hpp"
#include "pictures/expected.hpp"

namespace spanline::target {

// Holds every scene of make.cpp, in 64 KB.
inline constexpr Budget kPicturesBudget{.width = 160,
                                        .height = 160,
                                        .facets = 64,
                                        .vertices = 160,
                                        .polygons = 48,
                                        .edges = 200,
                                        .segments = 160,
                                        .samples = 64,
                                        .implied = 32,
                                        .gouraud = false,
                                        .walker = Walker::both};

// One for all ways to draw.
struct PicturesMemory {
  static inline FrameMemory<kPicturesBudget> pools;
  alignas(4) static inline std::uint8_t line[bytes_per_line(kPicturesBudget.format, kPicturesBudget.width)];
};

struct Decided {
  Status status;
  bool tiled;  // the spans followed each other without gap or overlap to the last pixel
  std::uint32_t crc;

  bool same_as(const Expected& expected) const { return status.ok() && tiled && crc == expected.crc; }
};

class FaceSum {
 public:
  explicit FaceSum(const Screen& screen) : screen_(screen) {}

  void add(const VisibleSpan& span) {
    tiled_ = tiled_ && pixels_ == std::uint32_t{span.line} * screen_.width + span.left;
    for (std::uint32_t column = span.left; column < span.right; ++column, ++pixels_) add(span.face);
  }
  void add(std::uint16_t face) {
    const std::uint8_t bytes[] = {static_cast<std::uint8_t>(face & 255), static_cast<std::uint8_t>(face >> 8)};
    crc_.add(bytes);
  }
  bool tiled() const { return tiled_ && pixels_ == std::uint32_t{screen_.width} * screen_.height; }
  std::uint32_t crc() const { return crc_.value(); }

  SpanTap tap() {
    return {this, [](void* context, const VisibleSpan& span) { static_cast<FaceSum*>(context)->add(span); }};
  }

 private:
  Screen screen_;
  std::uint32_t pixels_ = 0;
  bool tiled_ = true;
  golden::Crc32 crc_;
};

template <FrameOptions kOptions>
Decided decide(const Expected& picture) {
  FaceSum sum(picture.screen);
  SceneView scene;
  const Status status = SceneView::validate(*picture.scene, scene);
  if (!status.ok()) return {status, false, 0};
  FrameStorage storage = PicturesMemory::pools.storage();
  storage.screen = picture.screen;
  Frame<kOptions> frame(storage);
  frame.set_tap(sum.tap());
  frame_begin_mark();
  for (Band rest{0, picture.screen.height}; !rest.empty();) {
    const Band band = frame.prepare(scene, *picture.camera, rest);
    if (band.empty()) break;
    while (frame.next_line(PicturesMemory::line)) {
    }
    rest.top = band.bottom;
  }
  frame_end_mark();
  return {frame.status(), sum.tiled(), sum.crc()};
}

inline Decided decide_by_edges(const Expected& picture) {
  return decide<FrameOptions{.taps = true, .walker = Walker::edges}>(picture);
}

// tell(picture, way, what it came to) for every picture and way.
template <typename Tell>
void decide_all(const Tell& tell) {
  for (const Expected& picture : kExpected) {
    tell(picture, "plane", decide<FrameOptions{.comparator = Comparator::plane, .taps = true}>(picture));
    tell(picture, "midpoint", decide<FrameOptions{.comparator = Comparator::midpoint, .taps = true}>(picture));
    if (picture.edges) tell(picture, "edges", decide_by_edges(picture));
  }
}

}  // namespace spanline::target
