set(SPANLINE_CPU cortex-m4)
set(SPANLINE_LINKER_SCRIPT mps2.ld)
set(SPANLINE_MACHINE mps2-an386)  # QEMU's name
