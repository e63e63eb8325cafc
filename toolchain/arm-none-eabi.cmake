# Bare-metal Cortex-M with Debian's arm-none-eabi-g++. SPANLINE_CPU picks the core; floating point is soft on all of them,
# since the engine has none: what would need it shows up as an undefined symbol.
# SPANLINE_BOARD, a folder of firmware/boards or a path to one like those, brings its core along.
if(SPANLINE_BOARD)
  get_filename_component(spanline_board "${SPANLINE_BOARD}" ABSOLUTE BASE_DIR ${CMAKE_CURRENT_LIST_DIR}/../firmware/boards)
  if(NOT EXISTS ${spanline_board}/board.cmake)
    message(FATAL_ERROR "SPANLINE_BOARD is '${SPANLINE_BOARD}', and there is no ${spanline_board}/board.cmake")
  endif()
  include(${spanline_board}/board.cmake)
  set(SPANLINE_CPU ${SPANLINE_CPU} CACHE STRING "The board's core" FORCE)
endif()
set(SPANLINE_CPU cortex-m0 CACHE STRING "Cortex-M core, as GCC names it")
set(SPANLINE_CPUS cortex-m0 cortex-m0plus cortex-m3 cortex-m4 cortex-m7 cortex-m33)
set_property(CACHE SPANLINE_CPU PROPERTY STRINGS ${SPANLINE_CPUS})
if(NOT SPANLINE_CPU IN_LIST SPANLINE_CPUS)
  message(FATAL_ERROR "SPANLINE_CPU is '${SPANLINE_CPU}', which is none of: ${SPANLINE_CPUS}")
endif()

set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)  # there is no board to link for while CMake tries the compiler
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SPANLINE_CPU SPANLINE_BOARD)

set(spanline_cpu_flags "-mcpu=${SPANLINE_CPU} -mthumb -mfloat-abi=soft -ffunction-sections -fdata-sections")
set(CMAKE_C_FLAGS_INIT "${spanline_cpu_flags}")
set(CMAKE_CXX_FLAGS_INIT "${spanline_cpu_flags}")
set(CMAKE_ASM_FLAGS_INIT "${spanline_cpu_flags}")

# What every count of this project was made with; debug information stays out of the image. An option of the command line
# goes before it.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -g" CACHE STRING "Flags of the compiler for firmware")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
