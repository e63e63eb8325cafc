set(SPANLINE_CPU cortex-m3)
set(SPANLINE_LINKER_SCRIPT mps2.ld)
set(SPANLINE_MACHINE mps2-an385)  # QEMU's name
