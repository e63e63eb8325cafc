# spanline_firmware(NAME SOURCE…): an image for the board SPANLINE_BOARD out of the sources, its start-up and the
# engine: NAME.elf and, made from it, NAME.bin, NAME.hex, NAME.map and, where the boot ROM takes it, NAME.uf2.
# The board is a folder of firmware/boards, or a path to a folder like those.
set(SPANLINE_BOARDS_DIR ${CMAKE_CURRENT_LIST_DIR})
set(SPANLINE_LINKER_DIR ${CMAKE_CURRENT_LIST_DIR}/../../linker)
set(SPANLINE_UF2_SOURCE ${CMAKE_CURRENT_LIST_DIR}/../../toolchain/uf2)

if(SPANLINE_BOARD)
  get_filename_component(SPANLINE_BOARD_DIR "${SPANLINE_BOARD}" ABSOLUTE BASE_DIR ${SPANLINE_BOARDS_DIR})
  include(${SPANLINE_BOARD_DIR}/board.cmake)
  enable_language(ASM)
  # Last on every link line: integer helpers, memcpy and its kin, and nothing else of theirs.
  set(CMAKE_CXX_STANDARD_LIBRARIES "-lgcc -lc_nano -lgcc")
  # What shell scripts need to know of the board: emulate.sh here, ./dev.
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/board.sh CONTENT "\
cpu=${SPANLINE_CPU}
machine=${SPANLINE_MACHINE}
screendump=${SPANLINE_SCREENDUMP}
openocd=${SPANLINE_OPENOCD}
uf2=${SPANLINE_UF2}
")
endif()

# The tool that packs a UF2 runs on the build machine, so that machine's compiler makes it.
function(spanline_uf2_tool)
  if(TARGET spanline_uf2)
    return()
  endif()
  find_program(SPANLINE_HOST_CXX NAMES c++ g++ clang++ REQUIRED)
  set(tool ${CMAKE_CURRENT_BINARY_DIR}/uf2)
  set(sources ${SPANLINE_UF2_SOURCE}/main.cpp ${SPANLINE_UF2_SOURCE}/uf2.cpp)
  add_custom_command(OUTPUT ${tool}
    COMMAND ${SPANLINE_HOST_CXX} -std=c++20 -O1 -o ${tool} ${sources}
    DEPENDS ${sources} ${SPANLINE_UF2_SOURCE}/uf2.hpp)
  add_custom_target(spanline_uf2 DEPENDS ${tool})
  set_property(TARGET spanline_uf2 PROPERTY SPANLINE_TOOL ${tool})
endfunction()

function(spanline_firmware name)
  set(common ${SPANLINE_BOARDS_DIR}/common)
  set(script ${SPANLINE_LINKER_DIR}/${SPANLINE_LINKER_SCRIPT})
  list(TRANSFORM SPANLINE_BOARD_SOURCES PREPEND ${SPANLINE_BOARD_DIR}/ OUTPUT_VARIABLE board_sources)
  add_executable(${name} ${ARGN} ${common}/startup.cpp ${common}/report.cpp ${common}/frame_marks.cpp ${board_sources})
  set_target_properties(${name} PROPERTIES SUFFIX .elf
    LINK_DEPENDS "${script};${SPANLINE_LINKER_DIR}/flash.ld;${SPANLINE_LINKER_DIR}/ram.ld")
  target_compile_features(${name} PRIVATE cxx_std_20)
  # No loop becomes a call of memcpy: start-up runs before there is one. Freestanding, clang makes none by itself.
  target_compile_options(${name} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-ffreestanding;-fno-exceptions;-fno-rtti;-fno-threadsafe-statics>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-tree-loop-distribute-patterns>)
  target_include_directories(${name} PRIVATE ${SPANLINE_BOARD_DIR})
  target_link_options(${name} PRIVATE -nostdlib -L ${SPANLINE_LINKER_DIR} -T ${script} -Wl,--gc-sections
    -Wl,--no-warn-rwx-segments -Wl,-Map=$<TARGET_FILE_DIR:${name}>/${name}.map)
  target_link_libraries(${name} PRIVATE spanline::frame spanline::hal spanline_warnings)

  set(base $<TARGET_FILE_DIR:${name}>/${name})
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${CMAKE_OBJCOPY} -O binary ${base}.elf ${base}.bin
    COMMAND ${CMAKE_OBJCOPY} -O ihex ${base}.elf ${base}.hex)
  if(SPANLINE_UF2)
    spanline_uf2_tool()
    get_target_property(tool spanline_uf2 SPANLINE_TOOL)
    add_dependencies(${name} spanline_uf2)
    add_custom_command(TARGET ${name} POST_BUILD COMMAND ${tool} ${base}.bin ${base}.uf2)
  endif()
endfunction()
