// start_fans() and start_band_fans() in assembly, for cores with Thumb-2.
#include "core/vsg/edge_start_thumb2.hpp"
#include "core/vsg/fan_start_layout.hpp"

#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2

namespace spanline {

static_assert(fan_start_layout_holds<FanStart>() && band_start_layout_holds<BandStart>());

asm(SPANLINE_EDGE_SLOPE R"(
    .syntax unified
    .thumb

@ Throughout: r0 behind the edge at hand, r1 points, r2 words, r8 what the face on its left covers, r9 x of the vertex in
@ the upper half, r10 from it to the line's centre, r11 that centre, r12 out. The edge: r3 x, r4 dx, r5 toggle, r6 rest.
@ [sp] the fan's end, x of an edge that runs down from the vertex, the next vertex; from 16 on FanStart from not_drawn to
@ last; at 48 the FanStart.

@ What each kind has of its own: to the vertex r3, its fan r0 to r5, itself r9, the next r4; the lower end of the edge r0,
@ which it steps beyond, to r7; what face r4 covers, to `to`, and to `none` where that is nothing, which may take r3, r5
@ and lr; that lower end once more, to r3; on from a fan's end; whether there is room for an edge, or else to 70. Bytes
@ are as words, but for what a face covers.
    .macro fan_of_r4
    ldrd r6, r7, [sp, #32]          @ starts, fans
    add r6, r6, r4, lsl #1
    ldrh r0, [r6]
    ldrh r5, [r6, #2]
    .endm
    .macro fan_at_hand
    add r0, r7, r0, lsl #2
    add r5, r7, r5, lsl #2
    .endm
    .macro vertex_words
    ldrd r4, r5, [sp, #24]          @ first, count
    subs r4, r3, r4
    cmp r4, r5
    bhs 70f
    fan_of_r4
    ldr r9, [r1, r4, lsl #2]
    ldr r4, [sp, #40]               @ links
    fan_at_hand
    ldrh r4, [r4, r3, lsl #1]
    .endm
    .macro point_words site
    ldrh r3, [r0], #4
    ldr r7, [r1, r3, lsl #2]
    .endm
    .macro covers_by to, none, load:vararg
    cmp r4, #0
    blt \none
    \load
    ldrd r3, lr, [sp, #16]          @ not_drawn, cover
    cmp r5, r3
    beq \none
    add \to, r4, lr
    .endm
    .macro covers_words to, none
    covers_by \to, \none, ldrh r5, [r2, r4, lsl #1]
    .endm
    .macro again_words
    ldrh r3, [r0, #-4]
    ldr r3, [r1, r3, lsl #2]
    .endm
    .macro next_words
    b 1b
    .endm
    .macro rest_words
71: ldr r4, [sp, #48]
    b 72b
    .endm
    .macro room_words               @ takes r4
    ldr r4, [sp, #44]               @ last
    cmp r12, r4
    bhs 71f
    .endm

    .macro covers_bytes to, none
    covers_by \to, \none, ldrb r5, [r2, r4]
    .endm
@ In a band r1 are keys, r2 its vertices.
    .macro vertex_band
    add lr, r2, r3, lsl #3
    ldrd r5, r6, [sp, #24]          @ first, count
    ldrh r4, [lr, #4]
    subs r4, r4, r5
    cmp r4, r6
    bhs 70f
    fan_of_r4
    ldr r6, [sp, #44]               @ last
    fan_at_hand
    subs r7, r5, r0
    add r7, r12, r7, lsl #2
    cmp r7, r6
    bhi 70f
    ldr r9, [lr]
    ldrb r4, [lr, #6]
    .endm
    .macro point_band site
    ldrh r3, [r0], #4
    ldrb r7, [r1, r3]
    subs r7, #128
    bls 8\site\()f
    ldr r7, [r2, r7, lsl #3]
9\site:
    .endm
    .macro far_band site
8\site: bl 80f
    .if \site == 3
    ldr lr, [sp]
    .endif
    b 9\site\()b
    .endm
    .macro covers_band to, none
    cmp r4, #0
    blt \none
    ldrd r3, lr, [sp, #16]          @ drawn, skip
    add r4, lr
    lsrs r5, r4, #5
    ldr r3, [r3, r5, lsl #2]
    rors r3, r4
    lsls r3, #31
    bpl \none
    ldr lr, [sp, #40]               @ cover
    add \to, r4, lr
    .endm
    .macro again_band
    add r3, r9
    add r6, r11
    lsrs r3, #16
    orr r3, r3, r6, lsl #16
    .endm
    .macro next_band
    cmp r3, #0
    bne 1b
    .endm
    .macro room_band                @ of the whole fan there is
    .endm
    .macro rest_band
    far_band 1
    far_band 2
    far_band 3
80: cmn r7, #128
    beq 81f
    push {r0-r3, r12, lr}
    ldr r0, [sp, #72]
    ldr r0, [r0, #56]
    mov r1, r3
    bl spanline_place_vertex
    mov r7, r0
    pop {r0-r3, r12, pc}
81: mov r7, #1 << 31                @ above all lines
    bx lr
    .endm

    .macro start_fans kind, of
    .section .text.spanline_start_fans_\kind, "ax", %progbits
    .p2align 2
    .global spanline_start_fans_\kind
    .type spanline_start_fans_\kind, %function
    .thumb_func
spanline_start_fans_\kind:
    push {r0, r4-r11, lr}
    add lr, r0, #20
    ldm lr, {r4-r11}
    push {r4-r11}
    ldm r0, {r1-r3, r11, r12}
    sub sp, #16
    lsl r11, r11, #4
    add r11, #8

1:  vertex_\of
    sub r10, r11, r9, asr #16
    lsl r9, r9, #16
    add r7, r9, #1 << 19
    subs r7, #1
    strd r5, r7, [sp]
    str r4, [sp, #8]
    point_\of 1
    rsbs r6, r11, r7, asr #16
    ble 3f
    ldrsh r4, [r5, #-2]
    b 4f

@ Edges that do not reach the line.
2:  mov r5, lr
3:  cmp r0, r5
    beq 60f
    point_\of 2
    rsbs r6, r11, r7, asr #16
    ble 3b
    ldrsh r4, [r0, #-6]
4:  covers_\kind r8, 51f

@ Edges that do.
5:  ldrsh r4, [r0, #-2]
    covers_\kind r4, 52f
8:  subs r5, r4, r8
    beq 50f
    uxth lr, r8
    mov r8, r4
    room_\of
    rsb r3, r9, r7, lsl #16         @ across
    add r7, r6, r10                 @ down
    edge_slope r4, r3, r7, r4, 30f
    subs r6, #1
    asrs r6, r6, #4
    mul r3, r4, r10
    add r6, lr, r6, lsl #17
    ldrd lr, r7, [sp]
    add r3, r7, r3, asr #4
6:  ldr r7, [r12, #-16]
    cmp r3, r7
    blt 40f
    stm r12!, {r3-r6}
7:  cmp r0, lr
    beq 60f
    point_\of 3
    rsbs r6, r11, r7, asr #16
    bgt 5b
    b 2b

60: ldr r3, [sp, #8]
    next_\of

70: ldr r4, [sp, #48]
    str r3, [r4, #8]
72: str r12, [r4, #16]
    add sp, #52
    pop {r4-r11, pc}

51: mov r8, #0
    b 5b
52: mov r4, #0
    b 8b
50: ldr lr, [sp]                    @ covers nothing on either side
    b 7b

30: again_\of
    str r3, [r12]
    strd r5, lr, [r12, #8]
    push {r0-r2, r12}
    mov r0, r12
    sub r1, r11, r10
    lsls r1, r1, #16
    orr r1, r1, r9, lsr #16
    mov r2, r11
    bl spanline_run_far
    pop {r0-r2, r12}
    ldm r12, {r3-r6}
    ldr lr, [sp]
    b 6b

40: push {r0-r6, r12}
    ldr r0, [sp, #80]
    ldr r0, [r0, #52]
    mov r1, r12
    add r2, sp, #12
    bl spanline_insert_back
    pop {r0-r6, r12}
    add r12, #16
    ldr lr, [sp]
    b 7b
    rest_\of
    .size spanline_start_fans_\kind, . - spanline_start_fans_\kind
    .endm

    start_fans words, words
    start_fans bytes, words
    start_fans band, band
    .text
)");

}  // namespace spanline

#endif
