# The emulated board that frames are counted on: 4 MB each of code and RAM, so that any scene fits; SPANLINE_CPU names the
# core that an image is built for.
set(SPANLINE_LINKER_SCRIPT mps2.ld)
set(SPANLINE_BOARD_SOURCES ../../target/board/board.cpp)
