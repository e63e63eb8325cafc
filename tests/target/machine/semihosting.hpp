// How an image speaks to the emulator (or debugger) that runs it: Arm's semihosting calls.
#pragma once

#include <cstdint>

namespace spanline::target {

void print(const char* text);
void print(std::uint32_t number);

// Ends the run; `code` becomes the emulator's exit status.
[[noreturn]] void leave(int code);

}  // namespace spanline::target
