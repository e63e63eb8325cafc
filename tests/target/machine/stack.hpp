// How deep the stack has been, for a part of a run.
#pragma once

#include <cstdint>

namespace spanline::target {

// Paints the stack, runs `work`, and returns the bytes of stack that it used below the caller's frame, its return
// address included. An interrupt would add its own.
std::uint32_t stack_used_by(void (*work)());

}  // namespace spanline::target
