// How many random scenes a run looks at. Each suite is cut into shards so that ctest can spread them over the cores.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace spanline::test {

inline constexpr int kShards = 8;

// What the sanitizers slow down some ten times, they look at a third of: the engine without them has compared every
// scene, and what they find shows in the first ones.
#ifdef __SANITIZE_ADDRESS__
inline constexpr std::uint64_t kSliceShare = 3;
#else
inline constexpr std::uint64_t kSliceShare = 1;
#endif

// `slice` scenes, or `full` where the environment has SPANLINE_FULL=1.
inline std::uint64_t scene_count(std::uint64_t slice, std::uint64_t full) {
  const char* wish = std::getenv("SPANLINE_FULL");
  return wish != nullptr && wish[0] == '1' ? full : (slice + kSliceShare - 1) / kSliceShare;
}

}  // namespace spanline::test
