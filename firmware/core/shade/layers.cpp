// Layers over one another: a file of its own, so that an image without them does not hold it.
#include "core/shade/painter.hpp"
#include "core/shade/ramp.hpp"

namespace spanline {

namespace {

// A layer's colour, pixel by pixel from `left` on.
class LayerColors {
 public:
  LayerColors(const Layer& layer, std::uint16_t line, std::int32_t left)
      : channel_{make(layer, 0, line, left), make(layer, 1, line, left), make(layer, 2, line, left)} {}

  Rgb8 next() { return {step(channel_[0]), step(channel_[1]), step(channel_[2])}; }

 private:
  static Ramp make(const Layer& layer, int channel, std::uint16_t line, std::int32_t left) {
    const std::uint8_t flat[3] = {layer.color.r, layer.color.g, layer.color.b};
    if (layer.shade == nullptr) return {flat[channel] * 128, flat[channel] * 128, 1, 0};
    return {on_line(layer.shade->half[0], channel, line), on_line(layer.shade->half[1], channel, line),
            width_of(*layer.segment), left - first_column(*layer.segment)};
  }
  static std::uint8_t step(Ramp& ramp) {
    const auto value = static_cast<std::uint8_t>(ramp.value >> 16);
    ramp.value += ramp.step;
    return value;
  }

  Ramp channel_[3];
};

bool all_flat(const Slice<const Layer>& layers) {
  for (const Layer& layer : layers) {
    if (layer.shade != nullptr) return false;
  }
  return true;
}

}  // namespace

void Painter::layers(const LayeredSpan& span) {
  if (all_flat(span.layers)) return flat_layers(span);
  constexpr std::int32_t kAtOnce = 16;  // px
  Rgb8 pixels[kAtOnce];
  for (std::int32_t left = span.left; left < span.right; left += kAtOnce) {
    const std::int32_t count = span.right - left < kAtOnce ? span.right - left : kAtOnce;
    for (Rgb8& each : pixels) each = background_color_;
    for (std::uint32_t i = span.layers.size(); i-- > 0;) {
      LayerColors colors(span.layers[i], line_, left);
      for (std::int32_t x = 0; x < count; ++x) {
        pixels[x] = seen_through(colors.next(), span.layers[i].transmission, pixels[x]);
      }
    }
    for (std::int32_t x = 0; x < count; ++x) pixel(static_cast<std::uint32_t>(left + x), pixels[x]);
  }
}

void Painter::flat_layers(const LayeredSpan& span) {
  Rgb8 color = background_color_;
  for (std::uint32_t i = span.layers.size(); i-- > 0;) {
    color = seen_through(span.layers[i].color, span.layers[i].transmission, color);
  }
  fill(span.left, span.right, flat_payload(screen_.format, color));
}

void Painter::pixel(std::uint32_t x, const Rgb8& color) { fill(x, x + 1, flat_payload(screen_.format, color)); }

}  // namespace spanline
