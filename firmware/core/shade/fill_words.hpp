// Runs of equal words: what a line is mostly made of.
#pragma once

#include <cstdint>

#include "core/shade/brightness.hpp"
#include "core/vsg/line_walk.hpp"

namespace spanline {

// The line is bytes to everybody else.
using HalfPixels = std::uint16_t __attribute__((may_alias));
using WordPixels = std::uint32_t __attribute__((may_alias));

// Words in [at, end), at least 8 of them.
inline void fill_words_plain(WordPixels* at, const WordPixels* end, std::uint32_t word) {
  for (; end - at >= 8; at += 8) at[0] = at[1] = at[2] = at[3] = at[4] = at[5] = at[6] = at[7] = word;
  while (at != end) *at++ = word;
}

#if defined(__ARM_ARCH_ISA_THUMB)
// Several words an instruction, four instructions a turn; what is left is filled from the end.
[[gnu::noinline]] inline void fill_words(WordPixels* at, const WordPixels* end, std::uint32_t word) {
  register std::uint32_t r3 asm("r3") = word;
  register std::uint32_t r4 asm("r4") = word;
  register std::uint32_t r5 asm("r5") = word;
  register std::uint32_t r6 asm("r6") = word;
#if __ARM_ARCH_ISA_THUMB == 2
#define SPANLINE_BLOCK "{r3, r4, r5, r6, r8, r9, r10, r12}"
  register std::uint32_t r8 asm("r8") = word;
  register std::uint32_t r9 asm("r9") = word;
  register std::uint32_t r10 asm("r10") = word;
  register std::uint32_t r12 asm("r12") = word;
  constexpr int kBlock = 8;
#else
#define SPANLINE_BLOCK "{r3, r4, r5, r6}"
  constexpr int kBlock = 4;
#endif
  asm volatile(
      "b 2f\n"
      "1: stmia %0!, " SPANLINE_BLOCK "\n stmia %0!, " SPANLINE_BLOCK
      "\n"
      "   stmia %0!, " SPANLINE_BLOCK "\n stmia %0!, " SPANLINE_BLOCK
      "\n"
      "2: cmp %0, %2\n"
      "   bls 1b\n"
      "   b 4f\n"
      "3: stmia %0!, " SPANLINE_BLOCK
      "\n"
      "4: cmp %0, %1\n"
      "   bls 3b\n"
      "   mov %0, %1\n"
      "   stmia %0!, " SPANLINE_BLOCK
      : "+l"(at)
      : "l"(end - kBlock), "l"(end - 4 * kBlock), "r"(r3), "r"(r4), "r"(r5), "r"(r6)
#if __ARM_ARCH_ISA_THUMB == 2
                                                                                 ,
        "r"(r8), "r"(r9), "r"(r10), "r"(r12)
#endif
      : "cc", "memory");
#undef SPANLINE_BLOCK
}
#else
inline void fill_words(WordPixels* at, const WordPixels* end, std::uint32_t word) { fill_words_plain(at, end, word); }
#endif

// Fills the RGB565 pixels [left, right) of a line that begins on a word, and up to kOvershoot more.
inline void fill_span(std::uint8_t* line, std::int32_t left, std::int32_t right, std::uint32_t color) {
  auto* at = reinterpret_cast<HalfPixels*>(line) + left;
  if ((left & 1) != 0) *at++ = static_cast<std::uint16_t>(color);
  const std::uint32_t pair = color << 16 | color;
  auto* word = reinterpret_cast<WordPixels*>(at);
  auto* const end = reinterpret_cast<HalfPixels*>(line) + right;
  if (right - left >= 24) return fill_words(word, reinterpret_cast<WordPixels*>(line) + (right + 1) / 2, pair);
  do {
    word[0] = word[1] = pair;
    word += 2;
  } while (reinterpret_cast<HalfPixels*>(word) < end);
}

// The same, and not a pixel more.
inline void fill_exactly(std::uint8_t* line, std::int32_t left, std::int32_t right, std::uint32_t color) {
  auto* at = reinterpret_cast<HalfPixels*>(line) + left;
  auto* const end = reinterpret_cast<HalfPixels*>(line) + right;
  const auto pixel = static_cast<std::uint16_t>(color);
  if (end - at >= 18) {
    if ((left & 1) != 0) *at++ = pixel;
    auto* const last = reinterpret_cast<HalfPixels*>(line) + (right & ~1);
    fill_words(reinterpret_cast<WordPixels*>(at), reinterpret_cast<WordPixels*>(last), color << 16 | color);
    at = last;
  }
  while (at != end) *at++ = pixel;
}

// Fills the RGB565 pixels [left, right) of a line that begins on a word with a triangle's brightness in a material's
// colours, two at a time, and up to kOvershoot more.
inline void smooth_span(std::uint8_t* line, std::int32_t left, std::int32_t right, const BrightnessPlane& plane,
                        std::uint32_t y, const std::uint16_t* colors) {
  std::uint32_t bright = plane.at(static_cast<std::uint32_t>(left), y);
  const std::uint32_t step = plane.right;
  auto* at = reinterpret_cast<HalfPixels*>(line) + left;
  auto* const end = reinterpret_cast<HalfPixels*>(line) + right;
  if ((left & 1) != 0) {
    *at++ = colors[BrightnessPlane::entry(bright)];
    bright += step;
  }
  for (; at < end; at += 2) {
    const std::uint32_t first = colors[BrightnessPlane::entry(bright)];
    bright += step;
    *reinterpret_cast<WordPixels*>(at) = std::uint32_t{colors[BrightnessPlane::entry(bright)]} << 16 | first;
    bright += step;
  }
}

// The same, and no pixel more.
inline void smooth_exactly(std::uint8_t* line, std::uint32_t left, std::uint32_t right, const BrightnessPlane& plane,
                           std::uint32_t y, const std::uint16_t* colors) {
  const std::uint32_t even = right & ~1u;
  if (left < even)
    smooth_span(line, static_cast<std::int32_t>(left), static_cast<std::int32_t>(even), plane, y, colors);
  if (even == right) return;
  reinterpret_cast<HalfPixels*>(line)[even] = colors[BrightnessPlane::entry(plane.at(even, y))];
}

}  // namespace spanline
