#include "core/shade/painter.hpp"

#include <cstddef>

#include "core/shade/fill_words.hpp"
#include "core/shade/ramp.hpp"

namespace spanline {

namespace {

constexpr std::uint32_t kAllSamples = 16;  // of a pixel

std::uint8_t mix(std::uint8_t a, std::uint8_t b, std::uint32_t part, std::uint32_t whole) {
  return static_cast<std::uint8_t>((a * (whole - part) + b * part + whole / 2) / whole);
}

// (color * part + pixel * (16 - part)) / 16 in each channel of an RGB565 pixel in wire order.
std::uint16_t mix_wire(std::uint16_t pixel, const Rgb8& color, std::uint32_t part) {
  const std::uint32_t v = std::uint32_t{pixel} >> 8 | (std::uint32_t{pixel} & 0xffu) << 8;
  const auto channel = [=](std::uint32_t old, std::uint8_t fresh) {
    return mix(static_cast<std::uint8_t>(old), fresh, part, kAllSamples);
  };
  // What a panel shows of 5 or 6 bits has their upper ones repeated below.
  return rgb565_wire(channel((v >> 8 & 0xf8u) | (v >> 13 & 7u), color.r),
                     channel((v >> 3 & 0xfcu) | (v >> 9 & 3u), color.g),
                     channel((v << 3 & 0xf8u) | (v >> 2 & 7u), color.b));
}

}  // namespace

[[gnu::cold]] void Painter::begin_lines(const BackgroundRecord& background) {
  gradient_ = background.bottom != background.top && screen_.height > 1 ? &background : nullptr;
  set_background(background.top);
}

void Painter::shade_background() {
  const std::uint32_t whole = screen_.height - 1u;
  const auto part = [&](std::uint8_t top, std::uint8_t bottom) { return mix(top, bottom, line_, whole); };
  const Rgb8 &top = gradient_->top, &bottom = gradient_->bottom;
  set_background({part(top.r, bottom.r), part(top.g, bottom.g), part(top.b, bottom.b)});
}

[[gnu::noinline]] void Painter::set_background(const Rgb8& color) {
  background_color_ = color;
  background_ = flat_payload(screen_.format, color);
}

void Painter::span(const VisibleSpan& span) {
  if (span.face == kNoFace) return fill(span.left, span.right, background_);
  if (span.gouraud) return gouraud(span);
  fill(span.left, span.right, span.payload);
}

void Painter::fill(std::uint32_t left, std::uint32_t right, std::uint16_t payload) {
  if (screen_.format == PixelFormat::rgb565) {
    return fill_exactly(out_, static_cast<std::int32_t>(left), static_cast<std::int32_t>(right), payload);
  }
  for (std::uint32_t x = left; x < right; ++x) put_grey(x, payload);
}

void Painter::smooth(std::uint32_t left, std::uint32_t right, const BrightnessPlane& plane,
                     const std::uint16_t* colors) {
  if (screen_.format == PixelFormat::rgb565) return smooth_exactly(out_, left, right, plane, line_, colors);
  std::uint32_t bright = plane.at(left, line_);
  for (; left < right; ++left, bright += plane.right) put_grey(left, colors[BrightnessPlane::entry(bright)]);
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

void Painter::cover(const Rgb8& color, LineCoverage& coverage) {
  const std::uint32_t payload = flat_payload(screen_.format, color);
  auto* const pixels = reinterpret_cast<HalfPixels*>(out_);
  coverage.take([&](std::uint32_t x, std::uint32_t part) {
    if (screen_.format != PixelFormat::rgb565) return cover_grey(x, payload, part);
    pixels[x] = part == kAllSamples ? static_cast<std::uint16_t>(payload) : mix_wire(pixels[x], color, part);
  });
}

// Changes one pixel among those that share a byte; where its level is dithered, so is the new one.
void Painter::cover_grey(std::uint32_t x, std::uint32_t grey, std::uint32_t part) {
  const auto mixed = [=](std::uint32_t old) {
    return mix(static_cast<std::uint8_t>(old), static_cast<std::uint8_t>(grey), part, kAllSamples);
  };
  const auto put = [this](std::uint32_t at, std::uint32_t bits, std::uint32_t level, std::uint32_t up) {
    out_[at] = static_cast<std::uint8_t>((out_[at] & ~(bits << up)) | level << up);
  };
  switch (screen_.format) {
    case PixelFormat::grey4: {
      const std::uint32_t up = (x & 1u) != 0 ? 0 : 4, old = (std::uint32_t{out_[x / 2]} >> up & 15u) * 17;
      put(x / 2, 15, dither_grey4(mixed(old), x, line_), up);
      break;
    }
    case PixelFormat::mono1: {
      const std::uint32_t up = 7 - (x & 7u), old = (std::uint32_t{out_[x / 8]} >> up & 1u) * 255;
      put(x / 8, 1, dither_mono(mixed(old), x, line_), up);
      break;
    }
    default:
      out_[x] = mixed(out_[x]);
  }
}

void Painter::gouraud(const VisibleSpan& span) {
  std::int32_t from[3], to[3];
  for (int i = 0; i < 3; ++i) {
    from[i] = on_line(span.shade->half[0], i, line_);
    to[i] = on_line(span.shade->half[1], i, line_);
  }
  if (screen_.format == PixelFormat::rgb565) return gouraud_rgb565(span, from, to);
  gouraud_grey(span, from, to);
}

void Painter::gouraud_rgb565(const VisibleSpan& span, const std::int32_t (&from)[3], const std::int32_t (&to)[3]) {
  const std::int32_t width = width_of(*span.segment), skipped = span.left - first_column(*span.segment);
  Ramp r(from[0], to[0], width, skipped), g(from[1], to[1], width, skipped), b(from[2], to[2], width, skipped);
  auto* at = reinterpret_cast<HalfPixels*>(out_) + span.left;
  auto* const end = reinterpret_cast<HalfPixels*>(out_) + span.right;
  while (at != end) {
    // rgb565_wire() of the integer parts, without taking them out first.
    const std::uint32_t first = ((r.value >> 16) & 0xf8u) | g.value >> 21;
    *at++ = static_cast<std::uint16_t>(first | ((g.value >> 5) & 0xe000u) | ((b.value >> 11) & 0x1f00u));
    r.value += r.step;
    g.value += g.step;
    b.value += b.step;
  }
}

void Painter::gouraud_grey(const VisibleSpan& span, const std::int32_t (&from)[3], const std::int32_t (&to)[3]) {
  const auto grey = [](const std::int32_t(&c)[3]) { return (77 * c[0] + 150 * c[1] + 29 * c[2] + 128) >> 8; };
  Ramp ramp(grey(from), grey(to), width_of(*span.segment), span.left - first_column(*span.segment));
  for (std::uint32_t x = span.left; x < span.right; ++x) {
    put_grey(x, ramp.value >> 16);
    ramp.value += ramp.step;
  }
}

}  // namespace spanline
