// How deep the stack has been: it is painted, and what is painted no longer was used.
#pragma once

#include <cstdint>

namespace spanline::target {

// Paints everything below the caller's frame.
void paint_stack();

// Paints the stack, runs `work`, and returns the bytes of stack that it used below the caller's frame, its return
// address included. An interrupt would add its own.
std::uint32_t stack_used_by(void (*work)());

}  // namespace spanline::target
