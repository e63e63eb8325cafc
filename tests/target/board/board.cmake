# The emulated board that serves every core: SPANLINE_CPU names the one that an image is built for. A Cortex-M3 on
# silicon, any in QEMU.
set(SPANLINE_LINKER_SCRIPT lm3s6965.ld)
set(SPANLINE_BOARD_SOURCES board.cpp)
