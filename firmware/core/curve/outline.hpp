// Filled outlines of curves: contours whose chords are stepped off the curves.
#pragma once

#include "core/curve/side.hpp"
#include "core/geom/facet.hpp"

namespace spanline {

// Reads the contours of a FacetReader's current face, which is curved, as chords: each curve at as many equal steps as
// keep them within a quarter of a pixel of it, so that an outline is smooth at any size. The first and last points of
// curves are the records' own.
class OutlineReader {
 public:
  OutlineReader(const FacetReader& reader, const Screen& screen)
      : reader_(reader), view_(reader.camera(), screen, kTolerance) {
    if (reader.on_screen()) view_.near_w = kScreenDistance;
  }

  // As FacetReader::read; the vertices have no colours.
  template <typename Sink>
  void read(Sink& sink) const {
    const FaceRef& face = reader_.face();
    if (face.outside_all != 0) return;
    const std::uint32_t rings = face.contours.empty() ? 1 : face.contours.size();
    std::uint32_t begin = 0;
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
      const std::uint32_t end = face.contours.empty() ? face.corners.size() : begin + face.contours[ring];
      sink.begin_contour();
      if (reader_.clipped()) {
        read_clipped(begin, end, sink);
      } else {
        step_off(begin, end, [&](const ClipPoint& p) { sink.vertex(projected(p)); });
      }
      sink.end_contour();
      begin = end;
    }
  }

 private:
  static constexpr std::uint32_t kTolerance = 4;               // 1/16 px
  static constexpr std::int32_t kScreenDistance = Fx16::kOne;  // w of points on the screen

  // Hands the points of one ring to sink(const ClipPoint&).
  template <typename Sink>
  void step_off(std::uint32_t begin, std::uint32_t end, Sink&& sink) const {
    for (std::uint32_t i = begin; i < end; i += 3) {
      const ClipPoint p[4] = {point(i), point(i + 1), point(i + 2), point(i + 3 < end ? i + 3 : begin)};
      SideWalk<std::int64_t> walk(p, curve_steps(p, view_));
      for (std::uint32_t step = 0; step < walk.steps(); ++step) {
        sink(walk.at());
        walk.step();
      }
    }
  }

  template <typename Sink>
  [[gnu::noinline]]  // keeps the clipper's 500 bytes off the stack of the common path
  void
  read_clipped(std::uint32_t begin, std::uint32_t end, Sink& sink) const {
    ContourClipper clipper(reader_.projection(), reader_.face().outside_any);
    ClipVertex out;
    const auto drain = [&] {
      while (clipper.next(out)) sink.vertex(projected(out.at));
    };
    step_off(begin, end, [&](const ClipPoint& p) {
      clipper.feed({p, {}});
      drain();
    });
    clipper.finish();
    drain();
  }

  ClipPoint point(std::uint32_t corner) const;
  FacetVertex projected(const ClipPoint& p) const;

  const FacetReader& reader_;
  DiceView view_;
};

}  // namespace spanline
