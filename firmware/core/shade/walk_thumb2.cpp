// The walks of lines of RGB565 in assembly, for cores with Thumb-2: walk_on() of core/vsg/line_walk.hpp, with spans of
// one colour, and with smooth ones.
#include "core/shade/band_walk.hpp"
#include "core/shade/flat_walk.hpp"
#include "core/shade/grid_walk.hpp"
#include "core/shade/smooth_grid_walk.hpp"
#include "core/shade/walk_layout.hpp"

#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2

namespace spanline {

static_assert(walk_layout_holds<LineWalk, FaceLook, Brush<LookSlots>>());
static_assert(band_layout_holds<FaceColors, BandBrush>());

asm(R"(
    .syntax unified
    .thumb

@ Throughout: r1 edge, r2 out, r7 limit, r8 left, r9 key, r10 furthest, r11 pixels, r12 faces or the brush; [sp] the
@ walk, then its side. The edge at hand: r3 x, r4 dx, r5 toggle, r6 rest.

@ Fills the span up to the column of x = r3 with r4, up to eight pixels too far. Takes r0, r3 to r6 and lr; left comes to
@ the column. Where most are gaps and flat faces between smooth ones, short code will do.
    .macro fill_span long_ones=0
    add r0, r11, r8, lsl #1
    strh r4, [r0], #2
    bic r0, #3                      @ from here on whole words
    asr r8, r3, #20
    orr r4, r4, r4, lsl #16
    add r3, r11, r8, lsl #1
    strd r4, r4, [r0], #8
    cmp r0, r3
    bhs 9f
    .if \long_ones
    sub r5, r3, r0
    cmp r5, #64
    bhi 50f
8:  strd r4, r4, [r0], #8
    strd r4, r4, [r0], #8
    cmp r0, r3
    blo 8b
    .else
    .rept 2
    strd r4, r4, [r0], #8
    strd r4, r4, [r0], #8
    cmp r0, r3
    bhs 9f
    .endr
    sub r5, r3, r0
    cmp r5, #64
    bhi 50f
    mov r5, r4
    mov r6, r4
    mov lr, r4
    .rept 3
    stm r0!, {r4-r6, lr}
    cmp r0, r3
    bhs 9f
    .endr
    stm r0!, {r4-r6, lr}
    .endif
9:
    .endm

    .macro flat_state
    .endm

    .macro flat_tail unknown
    .endm

    .macro flat_background
    ldrh r4, [r12]
    .endm

@ The span of face r9, or from 5 on of face lr.
    .macro flat_span unknown
    uxth lr, r9
5:  ldrh r4, [r12, lr, lsl #1]
    fill_span
    .endm

    .macro band_flat_tail unknown
80: push {r1-r3, r12, lr}           @ as many as keep the stack aligned
    mov r1, lr
    ldrd r0, r4, [r12, #8]          @ from, learn
    blx r4
    mov r4, r0
    pop {r1-r3, r12, lr}
    b 81b
    .endm

    .macro band_flat_state
    ldr r12, [r0, #44]
    .endm

@ The same where the walk may not know the face's colour.
    .macro band_flat_span unknown
    uxth lr, r9
5:  ldm r12, {r0, r4}               @ colours, mask
    add r5, lr, lr, lsr #5          @ face_place()
    and r4, r5
    ldr r4, [r0, r4, lsl #2]
    uxth r5, r4
    cmp r5, lr
    bne 80f
    lsr r4, #16
81: fill_span
    .endm

@ The number of the look of face lr.
    .macro look_by_slot
    ldrb r4, [r4, lr]
    .endm
    .macro look_by_head
    add lr, lr, lr, lsr #5          @ LookChains::head_of()
    uxtb lr, lr
    ldrb r4, [r4, lr]
    .endm

    .macro grid_state
    lsr lr, lr, #1
    .endm

    .macro grid_tail unknown
    .endm

    .macro grid_background
    ldrh r4, [r12]
    .endm

@ The same, the colour that of the face's cell.
    .macro grid_span unknown
    ubfx lr, r9, #1, #15
5:  add lr, lr, lr, lsl #1
    ldrh r4, [r12, lr, lsl #2]
    fill_span
    .endm

@ The number of the look of face lr, of a cell's upper byte.
    .macro look_by_cell
    lsr lr, #1
    add lr, lr, lr, lsl #1
    add r4, r4, lr, lsl #2
    ldrb r4, [r4, #1]
    .endm

    .macro smooth_state
    ldr r12, [r0, #44]
    .endm

    .macro smooth_background
    ldr r4, [r12]
    ldrh r4, [r4, #4]
    .endm

@ 12 bytes each, which the table of smooth_span takes for granted: more of them are an error.
    .macro smooth_pixels count
    .rept \count
78:
    lsrs r3, r5, #26
    ldrh r3, [r6, r3, lsl #1]
    add r5, r4
    strh r3, [r0], #2
    .org 78b + 12
    .endr
    .endm

@ The same with the face's brightness.
    .macro smooth_span unknown, find=look_by_slot
    uxth lr, r9
5:  ldm r12, {r0, r4, r5, r6}       @ looks, slots or heads, material, line
    orr r5, lr
    \find
    add r4, r0, r4, lsl #4
    ldr lr, [r4, #12]
    cmp r5, lr
    bne 80f
    ldm r4, {r0, r4, r5}            @ at_zero, right, down
    mla r0, r6, r5, r0
    mla r5, r8, r4, r0
    add r0, r11, r8, lsl #1
    sub lr, r8, r3, asr #20         @ as many pixels less than none
    sub r8, lr
    ldr r6, [r12, #16]              @ colours
    adds lr, #8
    bpl 7f
6:  smooth_pixels 4
    adds lr, #4
    bmi 6b
7:  tbb [pc, lr]                    @ past those of eight that are too many
71: .set past, 0                    @ half the bytes from here to the first pixel, and those of a pixel
    .rept 8
    .byte 4 + 6 * past
    .set past, past + 1
    .endr
    smooth_pixels 8
    .endm

@ The span of a face whose look, r4 and lr, is not the brush's: of one colour, or else to `unknown`. The face is r5's.
    .macro look_tail unknown
80: movt r5, #0xffff
    cmp r5, lr
    bne \unknown
    ldrh r4, [r4, #4]
    fill_span long_ones=1
    b 4b
    .endm

@ The same where what is unknown is learned.
    .macro smooth_tail unknown
    look_tail 82f
82: push {r1-r3, r12, lr}           @ as many as keep the stack aligned
    uxth r5, r5
    mov r1, r5
    ldrd r0, r4, [r12, #20]         @ from, learn
    blx r4
    pop {r1-r3, r12, lr}
    mov lr, r5
    b 5b
    .endm

    .macro band_smooth_tail unknown
    smooth_tail
    .endm

    .macro band_smooth_state
    smooth_state
    .endm

    .macro band_smooth_span unknown
    smooth_span \unknown, look_by_head
    .endm

    .macro smooth_grid_state
    smooth_state
    .endm

    .macro smooth_grid_background
    smooth_background
    .endm

    .macro smooth_grid_tail unknown
    look_tail \unknown
    .endm

    .macro smooth_grid_span unknown
    smooth_span \unknown, look_by_cell
    .endm

@ The same, more than 16 pixels from where the span began; and 57, words of r4 from r0 on up to r3, eight at least, which
@ takes r1, r2, r5 to r7, r9 and r10.
    .macro long_fill
50: push {r1, r2, r7, r9, r10}
    adds r3, #2                     @ to the end of a word
    bic r3, r3, #3
    bl 57f
    pop {r1, r2, r7, r9, r10}
    b 9b
57: mov r1, r4
    mov r2, r4
    mov r5, r4
    mov r6, r4
    mov r7, r4
    mov r9, r4
    mov r10, r4
    subs r3, #128
    b 53f
52: .rept 4
    stm r0!, {r1, r2, r4-r7, r9, r10}
    .endr
53: cmp r0, r3
    bls 52b
    adds r3, #96
    b 55f
54: stm r0!, {r1, r2, r4-r7, r9, r10}
55: cmp r0, r3
    bls 54b
    stm r3, {r1, r2, r4-r7, r9, r10}  @ over what is there already
    bx lr
    .endm

@ With whole_lines there is an entry that begins a line, and the walk ends it: what is painted with knows the background.
    .macro walk kind, whole_lines=0
    .section .text.spanline_\kind\()_walk, "ax", %progbits
    .p2align 2
    .if \whole_lines
    .global spanline_\kind\()_line
    .type spanline_\kind\()_line, %function
    .thumb_func
spanline_\kind\()_line:
    push {r4-r11, lr}
    ldr r2, [r0, #40]
    ldrd r1, r3, [r0, #48]          @ now, alive_end
    ldrd r11, r12, [r0, #24]
    ldr lr, [r0, #36]
    adds r3, #16
    str r3, [r0, #32]
    ldr r7, [r3]
    cmp r7, lr
    it gt
    movgt r7, lr
    mov r8, #0
    mov r9, #0
    mov r10, #0x80000000
    push {r0, lr}
    \kind\()_state
    ldm r1!, {r3-r6}
    cmp r3, r7
    bgt 20f
    cmp r3, #18 << 20               @ mostly there is background first, at the beginning of a word
    blt 2f
    asr r8, r3, #20
    \kind\()_background
    mov r0, r11
    add r3, r11, r8, lsl #1
    orr r4, r4, r4, lsl #16
    b 50f
    .size spanline_\kind\()_line, . - spanline_\kind\()_line

    .p2align 2
    .endif
    .global spanline_\kind\()_walk
    .type spanline_\kind\()_walk, %function
    .thumb_func
spanline_\kind\()_walk:
    push {r4-r11, lr}
    movs lr, r1                     @ the face shown; nothing more sets flags
    ldm r0, {r1, r2, r7-r12}
    ldr r3, [r0, #36]
    \kind\()_state
    push {r0, r3}
    ldm r1!, {r3-r6}
    bne 5f
    b 6f
1:  ldm r1!, {r3-r6}
6:    cmp r3, r7
    bgt 20f
2:  cmp r8, r3, asr #20
    bge 3f
    cmp r9, #0x200000
    bhs 31f
    \kind\()_span 33f
4:  ldmdb r1, {r3-r6}
3:  add r9, r5
    subs r6, #0x20000
    blo 10f
    add r3, r4
    cmp r3, r10
    blt 40f
    mov r10, r3
    stm r2!, {r3-r6}
    ldm r1!, {r3-r6}
    cmp r3, r7
    ble 2b

@ The next edge is of the other run, or lies beyond the side.
20: ldr lr, [sp, #4]
    sub r1, #16
    cmp r7, lr
    beq 32f
    cmp r3, lr
    ite gt
    movgt r7, lr
    movle r7, r3
    ldr r0, [sp]
    ldr r3, [r0, #32]
    str r1, [r0, #32]
    mov r1, r3
    b 1b

@ The edge ends, or begins again.
10: tst r6, #0x10000
    beq 1b
    add r6, #0x20000
    stm r2, {r3-r6}
    movs r0, #2
    b 39f

31: subs r1, #16
    movs r0, #1
    b 39f
32:
    .if \whole_lines
    ldr r0, [sp]
    cmp r9, #0
    bne 34f
    mvn r4, #0x80000000
    cmp r3, r4
    bne 34f
    ldr r5, [r0, #32]
    ldr r5, [r5]
    cmp r5, r4
    beq 60f
34:
    .endif
    movs r0, #0
    b 39f
33: subs r1, #16
    movs r0, #3
39: pop {r3, r4}
    stm r3, {r1, r2, r7-r10}
    pop {r4-r11, pc}

@ Back to its place, as insert_back().
40: ldr lr, [sp]
    mov r0, r2
    ldr lr, [lr, #40]
    push {r7-r9}
41: ldmdb r0, {r7-r9, r11}
    stm r0, {r7-r9, r11}
    subs r0, #16
    cmp r0, lr
    beq 42f
    ldr r7, [r0, #-16]
    cmp r7, r3
    bgt 41b
42: stm r0, {r3-r6}
    pop {r7-r9}
    ldr r0, [sp]
    adds r2, #16
    ldr r11, [r0, #24]
    b 1b
    \kind\()_tail 33b
    long_fill

    .if \whole_lines
@ Nothing is left: as LineWalk::end_line(), and the background up to the line's end.
60: str r4, [r2]
    str r4, [r2, #16]
    ldr r5, [r0, #40]
    ldr r6, [r0, #48]
    str r6, [r0, #40]
    strd r5, r2, [r0, #48]
    \kind\()_background
    add r0, r11, r8, lsl #1
    asr r3, lr, #20
    add r3, r11, r3, lsl #1
    strh r4, [r0], #2
    adds r3, #16
    strh r4, [r3, #-2]
    bic r0, #3                      @ whole words
    bic r3, #3
    orr r4, r4, r4, lsl #16
    sub r5, r3, r0
    cmp r5, #32
    blt 62f
    bl 57b
    b 63f
61: str r4, [r0], #4
62: cmp r0, r3
    blo 61b
63: movs r0, #4
    pop {r3, r4}
    pop {r4-r11, pc}
    .endif
    .size spanline_\kind\()_walk, . - spanline_\kind\()_walk
    .endm

    walk flat, whole_lines=1
    walk grid, whole_lines=1
    walk smooth, whole_lines=1
    walk smooth_grid, whole_lines=1
    walk band_flat
    walk band_smooth
    .text
)");

}  // namespace spanline

#endif
