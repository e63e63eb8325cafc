// start_cells() in assembly, for cores with Thumb-2.
#include "core/vsg/edge_start_thumb2.hpp"
#include "core/vsg/grid_start.hpp"

#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2

namespace spanline {

static_assert(offsetof(GridList, vertices) == 0 && offsetof(GridList, key) == 4 && offsetof(GridList, line) == 8);
static_assert(offsetof(GridList, out) == 12 && offsetof(GridList, last) == 16);
static_assert(CellCovers::kUpper == 1 && CellCovers::kLower == 2 && CellCovers::kApart == 4 && kCoverCount == 20);

asm(SPANLINE_EDGE_SLOPE R"(
    .syntax unified
    .thumb

@ Throughout: r0 the vertex, r1 the next key, r2 the one below it in the grid, lr the one above, r8 x of an edge that
@ runs down from the vertex, r9 x of the vertex in the upper half, r10 from it to the line's centre, r11 that centre,
@ r12 out. The edge: r3 x, r4 dx, r5 toggle, r6 rest.
@ [sp] what the cells around the vertex cover, above left, below left, below right, above right, above left again: a
@ word, and the one after it, are what begins and what ends beside an edge to the left, down, right, up. At 20
@ GridList::last; at 24 what stands for the vertex above where there is none: no cells, above all lines; at 56 the
@ GridList.

@ The edge to `bottom`, what it parts at [sp, covers], if it reaches the line. Of the cells beyond the grid's rim none
@ covers anything; whatever is read there is in the pool, as rows are stepped off at its end.
    .macro edge site, bottom:req, covers
    ldr r7, \bottom
    rsbs r6, r11, r7, asr #16
    ble 7\site\()f
    ldrd r4, r5, [sp, #\covers]
    add r3, r6, r10                 @ down
    subs r6, #1
    lsls r6, r6, #13
    bfi r6, r5, #0, #17
    subs r5, r4, r5
    beq 7\site\()f
    rsb r4, r9, r7, lsl #16         @ across
    edge_slope r4, r4, r3, r7, 3\site\()f
    mul r3, r4, r10
    add r3, r8, r3, asr #4
6\site: ldr r7, [r12, #-16]
    cmp r3, r7
    ble 4\site\()f
    stm r12!, {r3-r6}
7\site:
    .endm

@ What is rare: edges that are long, and those that do not come behind the last one.
    .macro rare site, bottom:req
3\site: ldr r3, \bottom
    push {r0-r3, r12, lr}
    bl 30f
    pop {r0-r3, r12, lr}
    ldm r12, {r3-r6}
    b 6\site\()b
4\site: stm r12, {r3-r6}
    push {r0-r3, r12, lr}
    mov r0, r12
    bl spanline_take_in
    cmp r0, #0
    pop {r0-r3, r12, lr}
    it eq
    addeq r12, #16
    b 7\site\()b
    .endm

    .section .text.spanline_start_cells, "ax", %progbits
    .p2align 2
    .global spanline_start_cells
    .type spanline_start_cells, %function
    .thumb_func
spanline_start_cells:
    push {r0, r4-r11, lr}
    ldm r0, {r6, r8, r11, r12}
    ldr r7, [r0, #16]
    sub sp, #56
    mov r1, r8
    lsl r11, r11, #4
    add r11, #8
    movs r4, #0
    mov r5, #1 << 31
    strd r6, r7, [sp, #20]
    str r4, [sp, #28]
    strd r4, r5, [sp, #40]
    b 8f

1:  ldrd r5, r7, [sp, #20]
    cmp r12, r7
    bhi 69f
    add r0, r3, r3, lsl #1
    add r0, r5, r0, lsl #2
    ldm r0, {r7-r9}
    lsls r9, r9, #1                 @ whether it is of the first row
    lsr r9, r9, #25                 @ stride
    add r5, r9, r9, lsl #1
    add r2, r0, r5, lsl #2
    sub lr, r0, r5, lsl #2
    it cs
    addcs lr, sp, #40
    ldr r6, [r0, #-12]
    ldr r5, [lr]
    ldr r4, [lr, #-12]
    orrs r10, r7, r4                @ it is a corner of both triangles of these two
    bmi 69f
    lsls r3, r3, #1
    orr r3, r3, #1 << 20
    sub r10, r3, r9, lsl #1
    sbfx r7, r7, #29, #1
    ands r7, r3
    sbfx r6, r6, #29, #1
    subs r3, #2
    ands r6, r3
    sbfx r9, r5, #30, #1            @ the lower one
    add r5, r10, r5, lsr #31
    and r9, r9, r5
    sbfx r4, r4, #29, #1
    sub r10, #2
    and r4, r4, r10
    stm sp, {r4, r6, r7, r9}
    str r4, [sp, #16]
    sub r10, r11, r8, asr #16
    lsl r9, r8, #16
    add r8, r9, #1 << 19
    sub r8, #1

@ Counter-clockwise, so that they mostly come from left to right.
    ldr r7, [lr, #4]
    rsbs r6, r11, r7, asr #16
    ble 2f
    edge 1, "[r0, #-8]", 0
    edge 2, "[lr, #4]", 12
    mov lr, #0
2:  edge 3, "[r0, #16]", 8
    edge 4, "[r2, #4]", 4
    cmp lr, #0
    beq 8f
    edge 5, "[r0, #-8]", 0
8:  ldrh r3, [r1], #4
    cmp r3, #0
    bne 1b

69: subs r1, #4
    ldr r4, [sp, #56]
    str r1, [r4, #4]
    str r12, [r4, #12]
    clz r0, r3                      @ 1 if it is 0
    lsrs r0, r0, #5
    add sp, #60
    pop {r4-r11, pc}

    rare 1, "[r0, #-8]"
    rare 2, "[lr, #4]"
    rare 3, "[r0, #16]"
    rare 4, "[r2, #4]"
    rare 5, "[r0, #-8]"
30: uxth r6, r6
    str r3, [r12]
    strd r5, r6, [r12, #8]
    mov r0, r12
    sub r1, r11, r10
    lsls r1, r1, #16
    orr r1, r1, r9, lsr #16
    mov r2, r11
    b spanline_run_far
    .size spanline_start_cells, . - spanline_start_cells
    .text
)");

}  // namespace spanline

#endif
