set(SPANLINE_CPU cortex-m4)
set(SPANLINE_LINKER_SCRIPT stm32f429.ld)
set(SPANLINE_OPENOCD board/stm32f429disc1.cfg)
