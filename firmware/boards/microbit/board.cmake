set(SPANLINE_CPU cortex-m0)
set(SPANLINE_LINKER_SCRIPT nrf51822.ld)
set(SPANLINE_LACKS plot)  # whose pools do not fit 16 KB of RAM
set(SPANLINE_MACHINE microbit)  # QEMU's name
