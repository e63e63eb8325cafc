// How much of an image is the engine: read from the linker's map.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spanline::bench {

// What the linker placed of one section of one file, as the map names them; bytes.
struct Contribution {
  std::string section, member;
  std::uint32_t size = 0;
};

// The code and constants that the linker took from the engine's libraries and from the compiler's own (division and its
// like, which the engine calls), and what the engine's templates became in the image's own files. Throws InputError
// where `path` is no map of ours.
std::vector<Contribution> engine_contributions(const std::string& path);

// Their bytes; start-up, demos, scene tables and main are not in it. Throws InputError where `path` is no map of ours.
std::uint32_t engine_text_bytes(const std::string& path);

}  // namespace spanline::bench
