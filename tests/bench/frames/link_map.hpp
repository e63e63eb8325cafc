// How much of an image is the engine: read from the linker's map.
#pragma once

#include <cstdint>
#include <string>

namespace spanline::bench {

// Bytes of code and constants that the linker took from the engine's libraries and from the compiler's own (division
// and its like, which the engine calls); start-up, demos, scene tables and main are not in it. Throws InputError where
// `path` is no map of ours.
std::uint32_t engine_text_bytes(const std::string& path);

}  // namespace spanline::bench
