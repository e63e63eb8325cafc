#include "sim/engine.hpp"

#include <algorithm>

#include "core/frame/frame_impl.hpp"

namespace spanline::host {
namespace {

// The ramp is Q16.13 modulo 2^32: rounding may carry its ends a little out of 0 … 65535.
std::uint16_t top_16_bits(std::uint32_t depth) {
  return static_cast<std::uint16_t>(std::clamp(static_cast<std::int32_t>(depth) >> 13, 0, 65535));
}

void record_span(void* context, const VisibleSpan& span) {
  auto& out = *static_cast<Rendering*>(context);
  if (span.face == kNoFace) return;
  const std::size_t row = std::size_t{span.line} * out.picture.width;
  for (std::size_t x = span.left; x < span.right; ++x) {
    out.ids[row + x] = span.face + 1u;
    out.depth[row + x] = top_16_bits(span.depth.at(static_cast<std::int32_t>(x)));
  }
}

// A pixel with layers has the number and the depth of the nearest.
void record_layers(void* context, const LayeredSpan& span) { record_span(context, span.nearest()); }

template <FrameOptions kOptions>
class FrameEngine final : public Engine {
 public:
  explicit FrameEngine(const EngineOptions& options)
      : options_(options),
        memory_({options.width, options.height, options.format}, band_lines(options), options.pools),
        frame_(memory_.storage()),
        wire_(frame_.line_bytes()) {}

  Status render(const SceneView& scene, const CameraRecord& camera, Rendering& out) override {
    begin(out);
    std::uint16_t line = 0;
    for (Band rest{0, options_.height}; !rest.empty();) {
      const Band band = frame_.prepare(scene, camera, rest);
      if (band.empty()) return frame_.status();
      while (frame_.next_line({wire_.data(), static_cast<std::uint32_t>(wire_.size())})) {
        decode_line(options_.format, wire_.data(), options_.width,
                    out.picture.rgb.data() + std::size_t{3} * options_.width * line);
        if (options_.on_line) {
          options_.on_line({line, {wire_.data(), static_cast<std::uint32_t>(wire_.size())}});
        }
        ++line;
        note_line(out);
      }
      rest.top = band.bottom;
    }
    out.status = frame_.status();
    const bool drawn = out.status.ok() || out.status.code == Code::pool_exhausted;
    return drawn ? Status{} : out.status;
  }

 private:
  static std::uint16_t band_lines(const EngineOptions& options) {
    return static_cast<std::uint16_t>(std::max(1, options.height / std::max<int>(1, options.bands)));
  }

  void begin(Rendering& out) {
    const std::size_t pixels = std::size_t{options_.width} * options_.height;
    out.picture = Picture(options_.width, options_.height);
    out.status = {};
    out.lines.clear();
    before_ = {};
    if constexpr (kOptions.taps) {
      out.ids.assign(pixels, 0);
      out.depth.assign(pixels, 0);
      frame_.set_tap({&out, record_span, record_layers});
    }
  }

  void note_line(Rendering& out) {
    if constexpr (kOptions.statistics) {
      out.statistics = frame_.statistics();
      const Statistics& now = out.statistics;
      out.lines.push_back(
          {now.segment_references - before_.segment_references, now.output_segments - before_.output_segments});
      before_ = now;
    }
  }

  EngineOptions options_;
  HostMemory memory_;
  Frame<kOptions> frame_;
  std::vector<std::uint8_t> wire_;
  Statistics before_;
};

template <Comparator kComparator, Walker kWalker, bool kPoints>
std::unique_ptr<Engine> make_engine(const EngineOptions& options) {
  constexpr FrameOptions kPlain{
      .comparator = kComparator, .patches = true, .points = kPoints, .layers = !kPoints, .walker = kWalker};
  constexpr FrameOptions kObserved{.comparator = kComparator,
                                   .statistics = true,
                                   .taps = true,
                                   .patches = true,
                                   .points = kPoints,
                                   .layers = !kPoints,
                                   .walker = kWalker};
  if (options.observe) return std::make_unique<FrameEngine<kObserved>>(options);
  return std::make_unique<FrameEngine<kPlain>>(options);
}

std::unique_ptr<Engine> make_edge_engine(const EngineOptions& options) {
  constexpr FrameOptions kPlain{.walker = Walker::edges};
  constexpr FrameOptions kObserved{.statistics = true, .taps = true, .walker = Walker::edges};
  if (options.observe) return std::make_unique<FrameEngine<kObserved>>(options);
  return std::make_unique<FrameEngine<kPlain>>(options);
}

template <Comparator kComparator>
std::unique_ptr<Engine> make_engine(const EngineOptions& options) {
  if (options.surface == Surface::points) return make_engine<kComparator, Walker::segments, true>(options);
  return options.walker == Walker::segments ? make_engine<kComparator, Walker::segments, false>(options)
                                            : make_engine<kComparator, Walker::both, false>(options);
}

}  // namespace

std::unique_ptr<Engine> Engine::make(const EngineOptions& options) {
  if (options.walker == Walker::edges) return make_edge_engine(options);
  return options.comparator == Comparator::plane ? make_engine<Comparator::plane>(options)
                                                 : make_engine<Comparator::midpoint>(options);
}

}  // namespace spanline::host
