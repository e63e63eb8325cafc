#include "core/shade/flat_walk.hpp"

#include <cstddef>

#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2

namespace spanline {

static_assert(offsetof(LineWalk, edge) == 0 && offsetof(LineWalk, words) == 28, "loaded by one instruction");
static_assert(offsetof(LineWalk, furthest) == 20, "stored by one instruction");
static_assert(offsetof(LineWalk, fresh) == 32 && offsetof(LineWalk, side) == 36 && offsetof(LineWalk, begin) == 40);
static_assert(kTwoFaces == 1u << 21 && ActiveEdge::kOneLine == 1u << 17 && ActiveEdge::kTall == 1u << 16);
static_assert(ActiveEdge::kFraction == 20 && sizeof(ActiveEdge) == 16);
static_assert(static_cast<int>(WalkStop::side) == 0 && static_cast<int>(WalkStop::front) == 1 &&
              static_cast<int>(WalkStop::tall) == 2);

// r1 edge, r2 out, r7 limit, r8 left, r9 key, r10 furthest, r11 pixels, r12 words; [sp] walk; an edge: r3 x, r4 dx,
// r5 toggle, r6 rest.

// Fills a span of one face up to the column of x = r3. Takes r0, r3 … r6 and lr; r8 comes to the column.
#define FILL_SPAN                  \
  "  uxth lr, r9\n"                \
  "  ldrh r4, [r12, lr, lsl #1]\n" \
  "  add r0, r11, r8, lsl #1\n"    \
  "  tst r8, #1\n"                 \
  "  it ne\n"                      \
  "  strhne r4, [r0], #2\n"        \
  "  asr r8, r3, #20\n"            \
  "  orr r4, r4, r4, lsl #16\n"    \
  "  add r3, r11, r8, lsl #1\n"    \
  "  strd r4, r4, [r0], #8\n"      \
  "  cmp r0, r3\n"                 \
  "  bhs 9f\n"                     \
  "  strd r4, r4, [r0], #8\n"      \
  "  cmp r0, r3\n"                 \
  "  bhs 9f\n"                     \
  "  strd r4, r4, [r0], #8\n"      \
  "  cmp r0, r3\n"                 \
  "  bhs 9f\n"                     \
  "  strd r4, r4, [r0], #8\n"      \
  "  cmp r0, r3\n"                 \
  "  it lo\n"                      \
  "  bllo 50f\n"                   \
  "9:\n"

[[gnu::naked]] WalkStop flat_walk(LineWalk&) {
  asm volatile(
      "  push {r0, r4-r11, lr}\n"
      "  ldmia r0, {r1, r2, r7-r12}\n"
      "1: ldmia r1!, {r3-r6}\n"
      "  cmp r3, r7\n"
      "  bgt 20f\n"
      "2: cmp r8, r3, asr #20\n"
      "  bge 3f\n"
      "  cmp r9, #0x200000\n"
      "  bhs 30f\n" FILL_SPAN
      "  ldmdb r1, {r3-r6}\n"
      "3: add r9, r5\n"
      "  subs r6, #0x20000\n"
      "  blo 10f\n"
      "  add r3, r4\n"
      "  cmp r3, r10\n"
      "  blt 40f\n"
      "  mov r10, r3\n"
      "  stmia r2!, {r3-r6}\n"
      "  ldmia r1!, {r3-r6}\n"
      "  cmp r3, r7\n"
      "  ble 2b\n"

      // The next edge is one that begins, or lies beyond the side.
      "20: ldr r0, [sp]\n"
      "  sub r1, #16\n"
      "  ldr lr, [r0, #36]\n"
      "  cmp r7, lr\n"
      "  beq 32f\n"
      "  mov r3, r7\n"
      "  cmp r8, r3, asr #20\n"
      "  bge 21f\n"
      "  cmp r9, #0x200000\n"
      "  bhs 31f\n" FILL_SPAN
      "  ldr r0, [sp]\n"
      "  ldr lr, [r0, #36]\n"
      "21: ldr r4, [r0, #32]\n"
      "  adds r4, #16\n"
      "  str r4, [r0, #32]\n"
      "  ldr r7, [r4]\n"
      "  cmp r7, lr\n"
      "  it gt\n"
      "  movgt r7, lr\n"
      "  ldmdb r4, {r3-r6}\n"
      "  b 3b\n"

      // The edge ends.
      "10: tst r6, #0x10000\n"
      "  beq 1b\n"
      "  add r6, #0x20000\n"
      "  stmia r2, {r3-r6}\n"
      "  movs r0, #2\n"
      "  b 39f\n"

      "30: subs r1, #16\n"
      "31: movs r0, #1\n"
      "  b 39f\n"
      "32: movs r0, #0\n"
      "39: pop {r3}\n"
      "  stmia r3, {r1, r2, r7-r10}\n"
      "  pop {r4-r11, pc}\n"

      // Back to its place: as insert_back().
      "40: ldr lr, [sp]\n"
      "  mov r0, r2\n"
      "  ldr lr, [lr, #40]\n"
      "  push {r7-r9}\n"
      "41: ldmdb r0, {r7-r9, r11}\n"
      "  stmia r0, {r7-r9, r11}\n"
      "  subs r0, #16\n"
      "  cmp r0, lr\n"
      "  beq 42f\n"
      "  ldr r7, [r0, #-16]\n"
      "  cmp r7, r3\n"
      "  bgt 41b\n"
      "42: stmia r0, {r3-r6}\n"
      "  pop {r7-r9}\n"
      "  ldr r0, [sp]\n"
      "  adds r2, #16\n"
      "  ldr r11, [r0, #24]\n"
      "  b 1b\n"

      // Words of r4 from r0 to r3, which is more than 16 pixels beyond where the span began; lr returns.
      "50: push {r1, r2, r7, lr}\n"
      "  adds r3, #2\n"
      "  bic r3, r3, #3\n"
      "  mov r1, r4\n"
      "  mov r2, r4\n"
      "  mov r5, r4\n"
      "  mov r6, r4\n"
      "  mov r7, r4\n"
      "  subs r3, #96\n"
      "  b 52f\n"
      "51: stmia r0!, {r1, r2, r4-r7}\n"
      "  stmia r0!, {r1, r2, r4-r7}\n"
      "  stmia r0!, {r1, r2, r4-r7}\n"
      "  stmia r0!, {r1, r2, r4-r7}\n"
      "52: cmp r0, r3\n"
      "  bls 51b\n"
      "  adds r3, #72\n"
      "  b 54f\n"
      "53: stmia r0!, {r1, r2, r4-r7}\n"
      "54: cmp r0, r3\n"
      "  bls 53b\n"
      "  stmia r3, {r1, r2, r4-r7}\n"
      "  pop {r1, r2, r7, pc}\n");
}

#undef FILL_SPAN

}  // namespace spanline

#endif
