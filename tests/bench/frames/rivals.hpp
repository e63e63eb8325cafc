// What other libraries take for the frames of the benchmark: figures given by the project's plan, counted there under
// emulation for the same scenes, size, light and culling, at -O2.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spanline::bench {

struct Rival {
  const char* name;
  const char* scene;        // "S1"
  const char* cpu;          // "m4"
  const char* shading;      // "flat"
  std::uint32_t thousands;  // of instructions: drawing, and clearing colour and depth
};

// Those that drew the same frame on the same core, fastest first.
std::vector<Rival> rivals_of(const std::string& scene, const std::string& cpu, const std::string& shading);

}  // namespace spanline::bench
