#include "core/shade/painter.hpp"

namespace spanline {

namespace {

// The line is bytes to everybody else.
using Half = std::uint16_t __attribute__((may_alias));
using Word = std::uint32_t __attribute__((may_alias));

void fill_pairs(std::uint8_t* line, std::uint32_t left, std::uint32_t right, std::uint16_t pixel) {
  const std::uint32_t pair = std::uint32_t{pixel} << 16 | pixel;
  auto* at = reinterpret_cast<Half*>(line) + left;
  auto* const end = reinterpret_cast<Half*>(line) + right;
  if ((left & 1u) != 0) *at++ = pixel;
  for (; end - at >= 16; at += 16) {
    auto* const word = reinterpret_cast<Word*>(at);
    word[0] = word[1] = word[2] = word[3] = word[4] = word[5] = word[6] = word[7] = pair;
  }
  for (; end - at >= 2; at += 2) *reinterpret_cast<Word*>(at) = pair;
  if (at != end) *at = pixel;
}

std::uint8_t mix(std::uint8_t a, std::uint8_t b, std::uint32_t part, std::uint32_t whole) {
  return static_cast<std::uint8_t>((a * (whole - part) + b * part + whole / 2) / whole);
}

// One channel (or a weighted sum of them) of an edge at a line, Q8.7.
std::int32_t on_line(const EdgeShade& edge, int channel, std::uint16_t line) {
  const std::int32_t down = line + 2048 - edge.first_line_from_top;
  return edge.color[channel] + edge.step[channel] * down;
}

std::uint32_t channel(std::int32_t q16) {
  return q16 < 0 ? 0u : q16 > 0xffffff ? 255u : static_cast<std::uint32_t>(q16) >> 16;
}

}  // namespace

void Painter::begin_line(std::uint16_t line, std::uint8_t* out, const BackgroundRecord& background) {
  line_ = line;
  out_ = out;
  Rgb8 color = background.top;
  if (background.bottom != background.top && screen_.height > 1) {
    const std::uint32_t whole = screen_.height - 1u;
    color = {mix(background.top.r, background.bottom.r, line, whole),
             mix(background.top.g, background.bottom.g, line, whole),
             mix(background.top.b, background.bottom.b, line, whole)};
  }
  background_ = flat_payload(screen_.format, color);
}

void Painter::span(const VisibleSpan& span) {
  if (span.face == kNoFace) return fill(span.left, span.right, background_);
  if (span.gouraud) return gouraud(span);
  fill(span.left, span.right, span.payload);
}

void Painter::fill(std::uint32_t left, std::uint32_t right, std::uint16_t payload) {
  if (screen_.format == PixelFormat::rgb565) return fill_pairs(out_, left, right, payload);
  for (std::uint32_t x = left; x < right; ++x) put_grey(x, payload);
}

// Pixels that share a byte are written left to right, the first one clears it.
void Painter::put_grey(std::uint32_t x, std::uint32_t grey) {
  switch (screen_.format) {
    case PixelFormat::grey4: {
      std::uint8_t& byte = out_[x / 2];
      const std::uint32_t level = dither_grey4(grey, x, line_);
      byte = static_cast<std::uint8_t>((x & 1u) != 0 ? byte | level : level << 4);
      break;
    }
    case PixelFormat::mono1: {
      std::uint8_t& byte = out_[x / 8];
      const std::uint32_t bit = dither_mono(grey, x, line_) << (7 - (x & 7u));
      byte = static_cast<std::uint8_t>((x & 7u) != 0 ? byte | bit : bit);
      break;
    }
    default:
      out_[x] = static_cast<std::uint8_t>(grey);
  }
}

void Painter::gouraud(const VisibleSpan& span) {
  const EdgeShade& from = span.shade->half[0];
  const EdgeShade& to = span.shade->half[1];
  const std::int32_t left = span.segment->half[0].stepped_back().column;
  const std::int32_t width = span.segment->half[1].stepped_back().column - left;
  Ramp ramp[3];
  for (int i = 0; i < 3; ++i) {
    const std::int32_t start = on_line(from, i, line_);
    const std::int32_t step = ((on_line(to, i, line_) - start) * 512) / width;
    ramp[i] = {start * 512 + step * (span.left - left), step};
  }
  for (std::uint32_t x = span.left; x < span.right; ++x) {
    const std::uint32_t r = channel(ramp[0].value), g = channel(ramp[1].value), b = channel(ramp[2].value);
    if (screen_.format == PixelFormat::rgb565) {
      reinterpret_cast<Half*>(out_)[x] = rgb565_wire(r, g, b);
    } else {
      put_grey(x,
               luminance({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g), static_cast<std::uint8_t>(b)}));
    }
    for (Ramp& c : ramp) c.value += c.step;
  }
}

}  // namespace spanline
