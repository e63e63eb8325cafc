// How a board says what happened: to the emulator in text, to a person by its light.
#pragma once

#include <cstdint>

namespace spanline::boards {

void print(const char* text);
void print(std::uint32_t number);
void print_hex(std::uint32_t number);
void print_pair(const char* key, std::uint32_t value);  // "KEY=VALUE", a line of its own

// The end after a fault. Under an emulator: prints "fault: CAUSE, status=0x… at=0x…" and leaves with 1. On a board: for
// ever blinks `code` long flashes, a pause, the 32 bits of `status` from the top (long 1, short 0), a longer pause.
[[noreturn]] void stop(const char* cause, std::uint32_t code, std::uint32_t status, std::uint32_t at);

// The light of the board, by its main.
void light(bool on);

}  // namespace spanline::boards
