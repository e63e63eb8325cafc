set(SPANLINE_CPU cortex-m7)
set(SPANLINE_LINKER_SCRIPT mps2.ld)
set(SPANLINE_MACHINE mps2-an500)  # QEMU's name
