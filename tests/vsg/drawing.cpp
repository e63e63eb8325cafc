#include "vsg/drawing.hpp"

#include <memory>

#include "core/frame/frame_impl.hpp"

namespace spanline::test {
namespace {

constexpr FrameOptions with_taps(Comparator comparator, XSort x_sort, bool layers) {
  return {.comparator = comparator, .x_sort = x_sort, .statistics = true, .taps = true, .layers = layers};
}

std::size_t pixel_index(const Drawing& drawing, int column, int line) {
  return static_cast<std::size_t>(line) * static_cast<std::size_t>(drawing.faces.width) +
         static_cast<std::size_t>(column);
}

// Takes the spans of one frame and sees that they tile every line.
class Recorder {
 public:
  explicit Recorder(Drawing& drawing) : drawing_(drawing) {}

  void span(const VisibleSpan& span) {
    show(span);
    if (span.face == kNoFace) return;
    for (int column = span.left; column < span.right; ++column) {
      drawing_.stacks[pixel_index(drawing_, column, line_)] = {span.face};
    }
  }

  void layers(const LayeredSpan& span) {
    show(span.nearest());
    for (int column = span.left; column < span.right; ++column) {
      for (const Layer& layer : span.layers) {
        drawing_.stacks[pixel_index(drawing_, column, line_)].push_back(layer.face);
      }
    }
  }

  void show(const VisibleSpan& span) {
    if (span.line != line_ || span.left != column_ || span.right <= span.left || span.right > drawing_.faces.width) {
      drawing_.broken = "span " + std::to_string(span.left) + " - " + std::to_string(span.right) + " of line " +
                        std::to_string(span.line) + " came at column " + std::to_string(column_) + " of line " +
                        std::to_string(line_);
      return;
    }
    for (int column = span.left; column < span.right; ++column) {
      if (span.face == kNoFace) continue;
      drawing_.faces.at(column, line_) = span.face;
      drawing_.depths[pixel_index(drawing_, column, line_)] = static_cast<EngineDepth>(span.depth.at(column));
    }
    column_ = span.right;
  }

  void end_line() {
    if (column_ != drawing_.faces.width && drawing_.broken.empty()) {
      drawing_.broken = "line " + std::to_string(line_) + " ended at column " + std::to_string(column_);
    }
    ++line_;
    column_ = 0;
  }

  static SpanTap tap(Recorder& recorder) {
    return {&recorder, [](void* context, const VisibleSpan& span) { static_cast<Recorder*>(context)->span(span); },
            [](void* context, const LayeredSpan& span) { static_cast<Recorder*>(context)->layers(span); }};
  }

 private:
  Drawing& drawing_;
  int line_ = 0;
  int column_ = 0;
};

void apply(const PoolLimits& limits, FrameStorage& storage) {
  storage.facets.limit(limits.facets);
  storage.vertices.limit(limits.vertices);
  storage.vsg.polygons.limit(limits.polygons);
  storage.vsg.edges.limit(limits.edges);
  storage.vsg.segments.limit(limits.segments);
  storage.vsg.shades.limit(limits.segments);
  storage.vsg.active.limit(limits.active);
  storage.vsg.samples[0].limit(limits.samples);
  storage.vsg.samples[1].limit(limits.samples);
  storage.vsg.implied.limit(limits.implied);
  storage.vsg.layers.aside.limit(limits.layers);
  storage.vsg.layers.stack.limit(limits.layers);
}

template <Comparator kComparator, XSort kXSort, bool kLayers>
Drawing draw_with(const FrameStorage& storage, const SceneView& scene, const CameraRecord& camera,
                  const std::vector<std::uint16_t>& cuts) {
  Drawing drawing(storage.screen);
  Frame<with_taps(kComparator, kXSort, kLayers)> frame(storage);
  Recorder recorder(drawing);
  frame.set_tap(Recorder::tap(recorder));
  std::vector<std::uint32_t> words(frame.line_bytes() / 4 + 1);
  const Slice<std::uint8_t> line(reinterpret_cast<std::uint8_t*>(words.data()), frame.line_bytes());
  std::size_t next_cut = 0;
  for (Band rest{0, storage.screen.height}; !rest.empty();) {
    while (next_cut < cuts.size() && cuts[next_cut] <= rest.top) ++next_cut;
    const Band wanted{rest.top, next_cut < cuts.size() ? cuts[next_cut] : rest.bottom};
    const Band band = frame.prepare(scene, camera, wanted);
    if (band.empty()) break;
    ++drawing.bands;
    while (frame.next_line(line)) {
      drawing.bytes.insert(drawing.bytes.end(), line.begin(), line.end());
      recorder.end_line();
    }
    rest.top = band.bottom;
  }
  drawing.status = frame.status();
  drawing.statistics = frame.statistics();
  const std::size_t expected = std::size_t{frame.line_bytes()} * storage.screen.height;
  if (drawing.bytes.size() != expected && drawing.broken.empty()) drawing.broken = "lines are missing";
  return drawing;
}

}  // namespace

Drawing::Drawing(const Screen& screen)
    : faces(screen.width, screen.height), stacks(faces.faces.size()), depths(faces.faces.size(), 0) {}

Drawer::Drawer() : memory_(std::make_unique<FrameMemory<kRandomBudget>>()) {}

Drawing Drawer::draw(const SceneView& scene, const CameraRecord& camera, const Choices& choices) {
  FrameStorage storage = memory_->storage();
  apply(choices.limits, storage);
  if (choices.x_sort == XSort::buckets) {
    const auto buckets = std::make_unique<XSortBuckets<true>::Buckets>();
    storage.vsg.buckets = buckets.get();
    return draw_with<Comparator::plane, XSort::buckets, false>(storage, scene, camera, choices.cuts);
  }
  const bool by_plane = choices.comparator == Comparator::plane;
  const auto draw = choices.layers ? (by_plane ? draw_with<Comparator::plane, XSort::list, true>
                                               : draw_with<Comparator::midpoint, XSort::list, true>)
                                   : (by_plane ? draw_with<Comparator::plane, XSort::list, false>
                                               : draw_with<Comparator::midpoint, XSort::list, false>);
  return draw(storage, scene, camera, choices.cuts);
}

}  // namespace spanline::test
