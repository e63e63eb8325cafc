set(SPANLINE_CPU cortex-m0)
set(SPANLINE_LINKER_SCRIPT nrf51822.ld)
set(SPANLINE_MACHINE microbit)  # QEMU's name
