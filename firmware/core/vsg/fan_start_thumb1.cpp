// start_fans() and start_band_fans() in assembly, for cores with Thumb's 16-bit instructions alone (Armv6-M).
#include "core/vsg/fan_start_layout.hpp"

#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 1

namespace spanline {

static_assert(fan_start_layout_holds<FanStart>() && band_start_layout_holds<BandStart>());

asm(R"(
    .syntax unified
    .thumb

@ Throughout: r0 the edge at hand, r1 points, r2 the line's centre, r7 out, r8 what the face on its left covers, r9 x of
@ the vertex in the upper half, r10 from it to the centre, r11 words, r12 not_drawn, lr the fan's end. The edge: r3 its
@ lower end, then across; r6 from the centre down to that, then all the way down.
@ [sp] x of an edge that runs down from the vertex, the vertex, x of out[-1]; from 16 on FanStart from not_drawn to last;
@ at 64 the FanStart.

@ What each kind has of its own: the vertex after the one at hand, to r3; of the vertex r3 the fan r0 to lr and r5, and
@ itself, to r4; the lower end of the edge r0, to r3, which may take r4; what face r4 covers, to r4, and to `none` where
@ that is nothing, which may take r5; that lower end once more; whether there is room for an edge, or else to 70. Bytes are
@ as words, but for what a face covers.
    .macro fan_of_r4
    ldr r5, [sp, #28]               @ count
    cmp r4, r5
    bhs 70f
    lsls r6, r4, #1
    ldr r5, [sp, #32]               @ starts
    adds r5, r5, r6
    ldrh r0, [r5]
    ldrh r5, [r5, #2]
    lsls r0, r0, #2
    lsls r5, r5, #2
    ldr r6, [sp, #36]               @ fans
    adds r0, r0, r6
    adds r5, r5, r6
    mov lr, r5
    .endm
    .macro next_words
    ldr r4, [sp, #40]
    lsls r3, r3, #1
    ldrh r3, [r4, r3]
    .endm
    .macro vertex_words
    ldr r4, [sp, #24]               @ first
    subs r4, r3, r4
    fan_of_r4
    lsls r4, r4, #2
    ldr r4, [r1, r4]
    .endm
    .macro point_words site
    ldrh r3, [r0]
    lsls r3, r3, #2
    ldr r3, [r1, r3]
    .endm
    .macro covers_by none, upper, lower, load
    lsls r4, r4, #16
    bmi \none
    lsrs r4, r4, #\upper
    mov r5, r11
    \load r5, [r5, r4]
    cmp r5, r12
    beq \none
    .if \lower
    lsrs r4, r4, #\lower
    .endif
    ldr r5, [sp, #20]
    adds r4, r4, r5
    .endm
    .macro covers_words none
    covers_by \none, 15, 1, ldrh
    .endm
    .macro again_words
    point_words
    .endm
    .macro far_words
71: ldr r0, [sp, #64]
    b 72b
    .endm
    .macro room_words               @ takes r4
    ldr r4, [sp, #44]               @ last
    cmp r7, r4
    bhs 71f
    .endm

    .macro covers_bytes none
    covers_by \none, 16, 0, ldrb
    .endm
@ In a band r1 are keys, r11 its vertices, r12 the bits of faces.
    .macro next_band
    lsls r3, r3, #3
    add r3, r11
    ldrb r3, [r3, #6]
    cmp r3, #0
    bne 1f
    str r3, [sp, #4]
    b 70f
    .endm
    .macro vertex_band
    lsls r3, r3, #3
    add r3, r11
    ldrh r4, [r3, #4]
    ldr r5, [sp, #24]               @ first
    subs r4, r4, r5
    fan_of_r4
    subs r6, r5, r0
    lsls r6, r6, #2
    adds r6, r6, r7
    ldr r4, [sp, #44]               @ last
    cmp r6, r4
    bhi 70f
    ldr r4, [r3]
    .endm
    .macro point_band site
    ldrh r3, [r0]
    ldrb r4, [r1, r3]
    subs r4, #128
    bls 8\site\()f
    lsls r4, r4, #3
    add r4, r11
    ldr r3, [r4]
9\site:
    .endm
    .macro covers_band none
    lsls r4, r4, #16
    bmi \none
    lsrs r4, r4, #16
    ldr r5, [sp, #20]               @ skip
    adds r4, r4, r5
    lsrs r5, r4, #5
    lsls r5, r5, #2
    add r5, r12
    ldr r5, [r5]
    rors r5, r4
    lsls r5, r5, #31
    bpl \none
    ldr r5, [sp, #40]               @ cover
    adds r4, r4, r5
    .endm
    .macro again_band
    mov r4, r10
    subs r6, r6, r4
    adds r6, r6, r2
    add r3, r9
    lsrs r3, r3, #16
    lsls r6, r6, #16
    orrs r3, r6
    .endm
    .macro far_site site
8\site: mov r5, lr
    bl 80f
    mov lr, r5
    b 9\site\()b
    .endm
    .macro room_band                @ of the whole fan there is
    .endm
    .macro far_band
    far_site 1
    far_site 2
    far_site 3
80: adds r4, #128
    beq 81f
    push {r0-r2, lr}
    mov r4, r12
    ldr r0, [sp, #80]
    ldr r0, [r0, #56]
    movs r1, r3
    bl spanline_place_vertex
    movs r3, r0
    mov r12, r4
    pop {r0-r2, pc}
81: movs r3, #1                     @ above all lines
    lsls r3, r3, #31
    bx lr
    .endm

    .macro start_fans kind, of
    .section .text.spanline_start_fans_\kind, "ax", %progbits
    .p2align 2
    .global spanline_start_fans_\kind
    .type spanline_start_fans_\kind, %function
    .thumb_func
spanline_start_fans_\kind:
    push {r0, r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    mov r7, r11
    push {r4-r7}
    adds r0, #36
    ldmia r0!, {r4-r7}
    push {r4-r7}
    subs r0, #32
    ldmia r0!, {r4-r7}
    push {r4-r7}
    mov r12, r4
    subs r0, #36
    ldmia r0!, {r1-r3, r6, r7}
    mov r11, r2
    lsls r2, r6, #4
    adds r2, #8
    subs r7, #16
    ldmia r7!, {r4-r6}
    adds r7, #4
    sub sp, #16
    str r4, [sp, #8]
    b 1f

51: movs r4, #0
    b 9f
52: movs r4, #0
    b 8f

60: ldr r3, [sp, #4]
    next_\of
1:  str r3, [sp, #4]
    vertex_\of
    lsls r6, r4, #16
    mov r9, r6
    ldr r3, 100f
    adds r6, r6, r3
    str r6, [sp]
    asrs r4, r4, #16
    subs r4, r2, r4
    mov r10, r4
    point_\of 1
    asrs r6, r3, #16
    subs r6, r6, r2
    ble 3f
    subs r5, #4
    ldrh r4, [r5, #2]
    b 4f

70: ldr r0, [sp, #64]
    ldr r3, [sp, #4]
    str r3, [r0, #8]
72: str r7, [r0, #16]
    add sp, #48
    pop {r4-r7}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    mov r11, r7
    pop {r0, r4-r7, pc}

@ Edges that do not reach the line.
3:  adds r0, #4
    cmp r0, lr
    beq 60b
    point_\of 2
    asrs r6, r3, #16
    subs r6, r6, r2
    ble 3b
    subs r4, r0, #2                 @ to the face before
    ldrh r4, [r4]
4:  covers_\kind 51b
9:  mov r8, r4

@ Edges that do.
5:  ldrh r4, [r0, #2]
    covers_\kind 52b
8:  mov r5, r8
    mov r8, r4
    subs r4, r4, r5
    beq 7f                          @ covers nothing on either side
    str r4, [r7, #8]
    room_\of
    uxth r5, r5
    subs r4, r6, #1
    lsrs r4, r4, #4
    lsls r4, r4, #17
    adds r4, r4, r5
    str r4, [r7, #12]
    lsls r3, r3, #16
    mov r4, r9
    subs r3, r3, r4
    add r6, r10
    asrs r4, r3, #31
    eors r4, r3
    lsrs r4, r4, #18
    orrs r4, r6
    lsrs r4, r4, #8
    bne 30f
    lsls r6, r6, #2
    ldr r4, 101f
    ldr r4, [r4, r6]
    lsrs r5, r4, #8
    lsrs r6, r3, #31
    adds r5, r5, r6
    asrs r3, r3, #16
    muls r5, r3
    asrs r5, r4
    str r5, [r7, #4]
    mov r4, r10
    muls r4, r5
    asrs r4, r4, #4
    ldr r3, [sp]
    adds r3, r3, r4
    str r3, [r7]
6:  ldr r4, [sp, #8]
    cmp r3, r4
    blt 40f
    str r3, [sp, #8]
10: adds r7, #16
7:  adds r0, #4
    cmp r0, lr
    beq 61f
    point_\of 3
    asrs r6, r3, #16
    subs r6, r6, r2
    bgt 5b
    b 3b

61: b 60b
    far_\of

30: again_\of
    str r3, [r7]
    str r5, [r7, #12]
    mov r4, lr
    mov r5, r12
    push {r0-r3}
    mov r3, r10
    subs r1, r2, r3
    lsls r1, r1, #16
    mov r3, r9
    lsrs r3, r3, #16
    orrs r1, r3
    mov r0, r7
    bl spanline_run_far
    pop {r0-r3}
    mov lr, r4
    mov r12, r5
    ldr r3, [r7]
    b 6b

40: mov r4, lr
    mov r5, r12
    push {r0-r3}
    mov r0, r7
    ldmia r0!, {r1-r3, r6}
    push {r1-r3, r6}
    mov r1, r7
    mov r2, sp
    ldr r0, [sp, #96]
    ldr r0, [r0, #52]
    bl spanline_insert_back
    add sp, #16
    pop {r0-r3}
    mov lr, r4
    mov r12, r5
    b 10b

    .p2align 2
100:  .word (1 << 19) - 1             @ half a pixel less, a pixel less a unit more
101:  .word spanline_reciprocals
    .size spanline_start_fans_\kind, . - spanline_start_fans_\kind
    .endm

    start_fans words, words
    start_fans bytes, words
    start_fans band, band
    .text
)");

}  // namespace spanline

#endif
