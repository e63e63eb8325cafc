set(SPANLINE_CPU cortex-m0plus)                # the core, as GCC names it
set(SPANLINE_LINKER_SCRIPT rp2040.ld)          # of linker/
set(SPANLINE_BOARD_SOURCES ../pico/boot2.S)    # the board's own sources; most have none
set(SPANLINE_UF2 yes)                          # only where the boot ROM takes UF2
# set(SPANLINE_OPENOCD board/my_board.cfg)     # how ./dev flash reaches it
# set(SPANLINE_MACHINE my-board)               # QEMU's name, where QEMU has it
# set(SPANLINE_SCREENDUMP yes)                 # … and shows its panel
