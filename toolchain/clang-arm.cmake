# The second compiler: clang makes the code, with the headers of arm-none-eabi-g++, which links.
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
# clang marks every function as one that cannot be unwound, which an image without exceptions need not say.
set(CMAKE_CXX_COMPILE_OBJECT "<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> -o <OBJECT> -c <SOURCE>"
  "arm-none-eabi-objcopy --remove-section=.ARM.exidx* <OBJECT>")
set(CMAKE_CXX_LINK_EXECUTABLE
  "arm-none-eabi-g++ ${spanline_cpu_flags} -Wl,-z,noexecstack <LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")

# The library's headers, as that compiler finds them; its own, of built-in functions, are clang's own here.
execute_process(COMMAND arm-none-eabi-g++ -mcpu=${SPANLINE_CPU} -mthumb -v -x c++ -E /dev/null -o /dev/null
  ERROR_VARIABLE spanline_said OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n /[^\n ]*arm-none-eabi/include[^\n ]*" spanline_headers "${spanline_said}")
list(TRANSFORM spanline_headers REPLACE "\n " " -isystem ")
string(JOIN "" spanline_headers ${spanline_headers})

set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
foreach(language C CXX ASM)
  set(CMAKE_${language}_COMPILER_TARGET arm-none-eabi)
endforeach()
set(CMAKE_CXX_FLAGS_INIT "${spanline_cpu_flags} -fshort-enums -nostdinc++${spanline_headers}")
