set(SPANLINE_CPU cortex-m3)
set(SPANLINE_LINKER_SCRIPT lm3s6965.ld)
set(SPANLINE_MACHINE lm3s6965evb)  # QEMU's name
set(SPANLINE_SCREENDUMP yes)       # QEMU shows the panel
set(SPANLINE_OPENOCD board/ek-lm3s6965.cfg)
