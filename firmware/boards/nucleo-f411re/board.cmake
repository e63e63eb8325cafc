set(SPANLINE_CPU cortex-m4)
set(SPANLINE_LINKER_SCRIPT stm32f411.ld)
set(SPANLINE_OPENOCD board/st_nucleo_f4.cfg)
