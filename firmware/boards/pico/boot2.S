/* Second-stage boot of the RP2040: the boot ROM copies these 256 bytes to RAM and calls them, if the checksum in the
   last word is right. They put the flash interface into plain serial reads (command 03h, known to every flash chip; at
   125 MHz divided by 4 it stays below the 50 MHz that the slowest of them allow) and start the image behind them. No
   wait: nothing here can hang. */
  .syntax unified
  .cpu cortex-m0plus
  .thumb

  .section .boot2, "ax"
  .equ ssi, 0x18000000
  .equ control0, 0x00
  .equ control1, 0x04
  .equ enable, 0x08
  .equ divider, 0x14
  .equ spi_control0_high, 0xF4

  .global boot2
  .type boot2, %function
boot2:
  push {lr}
  ldr r3, =ssi
  movs r1, #0
  str r1, [r3, #enable]
  movs r1, #4
  str r1, [r3, #divider]
  ldr r1, =(31 << 16) | (3 << 8)            @ standard SPI, 32 bits a read, transmit an address, then receive
  str r1, [r3, #control0]
  ldr r1, =(0x03 << 24) | (2 << 8) | (6 << 2) @ command 03h, 8 bits of command, 24 bits of address
  movs r0, #spi_control0_high
  adds r0, r0, r3
  str r1, [r0]
  movs r1, #0
  str r1, [r3, #control1]                   @ one read a request
  movs r1, #1
  str r1, [r3, #enable]

  pop {r0}
  cmp r0, #0
  beq start                                 @ called by the boot ROM; anybody else gets control back
  bx r0

start:
  ldr r0, =0x10000100                       @ the vector table
  ldr r1, =0xE000ED08                       @ VTOR
  str r0, [r1]
  ldr r1, [r0, #4]
  ldr r0, [r0]
  mov sp, r0
  bx r1
  .pool

  .org 252, 0
  .word 0x64064b69                          @ CRC-32/MPEG-2 of the 252 bytes before
