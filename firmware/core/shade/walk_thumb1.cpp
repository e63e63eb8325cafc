// The walks of lines of RGB565 in assembly, for cores with Thumb's 16-bit instructions alone (Armv6-M): walk_on() of
// core/vsg/line_walk.hpp, with spans of one colour, and with smooth ones.
#include "core/shade/band_walk.hpp"
#include "core/shade/flat_walk.hpp"
#include "core/shade/walk_layout.hpp"

#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 1

namespace spanline {

static_assert(walk_layout_holds<LineWalk, FaceLook, Brush<LookSlots>>());
static_assert(band_layout_holds<FaceColors, BandBrush>());

asm(R"(
    .syntax unified
    .thumb

@ Throughout: r1 edge, r2 out, r8 limit, r9 left in bytes, r10 key, r11 pixels, r12 faces or the brush, lr furthest;
@ [sp] the walk, its side, 1 << 17, the brush's line. The edge at hand: r3 x, r4 dx, r5 toggle, r6 rest. r7 is 1 << 17
@ or the colours.

@ Fills the span up to the column r3, in bytes, with r4, up to eight pixels too far. Takes r0, r3 to r6; left comes to
@ the column.
    .macro fill_span
    mov r0, r9
    mov r9, r3
    add r0, r11
    add r3, r11
    lsls r5, r4, #16
    orrs r5, r4
    lsrs r6, r0, #2
    bcc 7f
    strh r4, [r0]
    adds r0, #2                     @ from here on whole words
7:  mov r6, r5
    stmia r0!, {r5, r6}
    cmp r0, r3
    bhs 9f
    .rept 3
    stmia r0!, {r5, r6}
    stmia r0!, {r5, r6}
    cmp r0, r3
    bhs 9f
    .endr
    b 50f
    .endm

@ Words of r5 and r6 from r0 on up to r3, more than 24 bytes from where the span began.
    .macro long_fill
50: push {r1, r2, r7}
    adds r3, #2                     @ to the end of a word
    lsrs r3, r3, #2
    lsls r3, r3, #2
    mov r1, r5
    mov r2, r5
    mov r4, r5
    mov r7, r5
    subs r3, #96
    b 53f
52: .rept 4
    stmia r0!, {r1, r2, r4-r7}
    .endr
53: cmp r0, r3
    bls 52b
    adds r3, #72
    b 55f
54: stmia r0!, {r1, r2, r4-r7}
55: cmp r0, r3
    bls 54b
    stmia r3!, {r1, r2, r4-r7}      @ over what is there already
    pop {r1, r2, r7}
    b 9b
    .endm

@ The span of face r0, the key.
    .macro flat_span
    lsls r0, r0, #16
    lsrs r0, r0, #15
    add r0, r12
    ldrh r4, [r0]
    fill_span
9:
    .endm

    .macro flat_count_down
    subs r6, r7
    .endm

    .macro flat_state
    ldr r3, [r0]
    mov r12, r3
    movs r7, #1
    lsls r7, r7, #17
    .endm

    .macro flat_tail
    long_fill
    .endm

@ The same where the walk may not know the face's colour.
    .macro band_flat_span
    uxth r4, r0
    mov r6, r12
    ldmia r6!, {r0, r5}             @ colours, mask
    lsrs r6, r4, #5                 @ face_place()
    adds r6, r6, r4
    ands r5, r6
    lsls r5, r5, #2
    ldr r0, [r0, r5]
    uxth r5, r0
    cmp r5, r4
    bne 80b
    lsrs r4, r0, #16
81: fill_span
9:
    .endm

@ Calls what learns face r4's look, which stands behind the painter, r12, at `at`. Keeps in r5 and r6 what it may not
@ push.
    .macro learn at
80: push {r1-r3}                    @ as many as keep the stack aligned
    mov r5, r12
    mov r6, lr
    movs r1, r4
    ldr r0, [r5, #\at]              @ from
    ldr r2, [r5, #\at + 4]          @ learn
    blx r2
    mov r12, r5
    mov lr, r6
    pop {r1-r3}
    .endm
    .macro flat_learn
    .endm
    .macro band_flat_learn
    learn 8
    movs r4, r0
    b 81f
    .endm

    .macro band_flat_count_down
    subs r6, r7
    .endm

    .macro band_flat_state
    ldr r3, [r0, #16]
    mov r12, r3
    movs r7, #1
    lsls r7, r7, #17
    .endm

    .macro band_flat_tail
    long_fill
    .endm

@ The number of the look of face r4, whose material r6 comes above it.
    .macro look_by_slot
    ldrb r5, [r5, r4]
    orrs r4, r6
    .endm
    .macro look_by_head
    orrs r4, r6
    lsls r6, r4, #16
    lsrs r6, r6, #21                @ LookChains::head_of()
    adds r6, r6, r4
    uxtb r6, r6
    ldrb r5, [r5, r6]
    .endm

    .macro smooth_pixels count
    .set at, 0
    .rept \count
    lsrs r6, r4, #26
    lsls r6, r6, #1
    ldrh r6, [r7, r6]
    adds r4, r5
    strh r6, [r0, #at]
    .set at, at + 2
    .endr
    adds r0, #at
    .endm

@ The same with the face's brightness, up to three pixels too far.
    .macro smooth_span find=look_by_slot
    uxth r4, r0
    mov r6, r12
    ldmia r6, {r0, r5, r6}          @ looks, slots or heads, material
    \find
    lsls r5, r5, #4
    adds r5, r0
    ldr r6, [r5, #12]
    cmp r4, r6
    bne 60f
    ldmia r5, {r4, r5, r6}          @ at_zero, right, down
    ldr r0, [sp, #12]
    muls r6, r0, r6
    adds r4, r6
    mov r0, r9
    lsrs r6, r0, #1
    muls r6, r5, r6
    adds r4, r6
    mov r9, r3
    add r0, r11
    add r3, r11
    .rept 2
    smooth_pixels 2
    cmp r0, r3
    bhs 9f
    .endr
7:  smooth_pixels 4
    cmp r0, r3
    blo 7b
9:
    .endm

    .macro smooth_count_down
    ldr r0, [sp, #8]
    subs r6, r0
    .endm

    .macro smooth_state
    ldr r3, [r0, #16]
    mov r12, r3
    ldr r7, [r3, #12]
    str r7, [sp, #12]
    ldr r7, [r3, #16]
    .endm

    .macro smooth_tail
60: mvns r6, r6                     @ whose look r5 is
    mvns r4, r4
    uxth r4, r4
    cmp r4, r6
    beq 61f
    b 82b
61: ldrh r4, [r5, #4]               @ one colour
    fill_span
9:  b 3b
    long_fill
    .endm

    .macro band_smooth_span
    smooth_span look_by_head
    .endm
    .macro band_smooth_count_down
    smooth_count_down
    .endm
    .macro band_smooth_state
    smooth_state
    .endm
    .macro band_smooth_tail
    smooth_tail
    .endm
    .macro smooth_learn
82: mvns r4, r4                     @ as smooth_tail leaves it
    uxth r4, r4
    learn 20
    ldr r7, [r5, #16]
    movs r0, r4
    b 5f
    .endm
    .macro band_smooth_learn
    smooth_learn
    .endm

    .macro walk name, kind
    .section .text.\name, "ax", %progbits
    .p2align 2
    .global \name
    .type \name, %function
    .thumb_func
\name:
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    mov r7, r11
    push {r4-r7}
    mov r4, r0
    ldr r5, [r0, #36]
    movs r6, #1
    lsls r6, r6, #17
    mov r7, r1                      @ the face shown
    push {r4-r7}
    ldmia r0!, {r1-r7}
    mov r8, r3
    adds r4, r4
    mov r9, r4
    mov r10, r5
    mov lr, r6
    mov r11, r7
    ldr r6, [sp, #12]
    \kind\()_state
    movs r0, r6
    beq 1f
    ldr r3, [r1]
    asrs r3, r3, #20
    adds r3, r3
    b 5f

31: movs r0, #1
    b 39f
32: movs r0, #0
39: ldr r3, [sp]
    mov r4, r8
    mov r5, r9
    lsrs r5, r5, #1
    mov r6, r10
    mov r7, lr
    stmia r3!, {r1, r2, r4-r7}
    add sp, #16
    pop {r4-r7}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    mov r11, r7
    pop {r4-r7, pc}

    \kind\()_learn
@ The next edge is of the other run, or lies beyond the side.
20: ldr r0, [sp, #4]
    cmp r8, r0
    beq 32b
    cmp r3, r0
    ble 21f
    mov r3, r0
21: mov r8, r3
    ldr r0, [sp]
    ldr r3, [r0, #32]
    str r1, [r0, #32]
    mov r1, r3

1:  ldr r3, [r1]
    cmp r3, r8
    bgt 20b
2:  asrs r3, r3, #20
    adds r3, r3
    cmp r9, r3
    bge 3f
    mov r0, r10
    lsrs r4, r0, #21
    bne 31b
5:  \kind\()_span
3:  ldmia r1!, {r3-r6}
    add r10, r5
    \kind\()_count_down
    blo 10f
    adds r3, r4
    cmp r3, lr
    blt 40f
    mov lr, r3
    stmia r2!, {r3-r6}
    ldr r3, [r1]
    cmp r3, r8
    ble 2b
    b 20b

@ The edge ends, or begins again.
10: lsls r0, r6, #15
    bpl 1b
    ldr r0, [sp, #8]
    adds r6, r0
    stmia r2!, {r3-r6}
    subs r2, #16
    movs r0, #2
    b 39b

@ Back to its place, as insert_back().
40: push {r1, r7}
    ldr r0, [sp, #8]
    ldr r0, [r0, #40]
    mov r1, r2
41: subs r1, #16
    .irp at, 0, 4, 8, 12
    ldr r7, [r1, #\at]
    str r7, [r1, #16 + \at]
    .endr
    cmp r1, r0
    beq 42f
    mov r7, r1
    subs r7, #16
    ldr r7, [r7]
    cmp r7, r3
    bgt 41b
42: stmia r1!, {r3-r6}
    pop {r1, r7}
    adds r2, #16
    b 1b
    \kind\()_tail
    .size \name, . - \name
    .endm

    walk spanline_flat_walk, flat
    walk spanline_smooth_walk, smooth
    walk spanline_band_flat_walk, band_flat
    walk spanline_band_smooth_walk, band_smooth
    .text
)");

}  // namespace spanline

#endif
