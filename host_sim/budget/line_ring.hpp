// How many line buffers keep a wire busy.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace spanline::host {

struct LineTime {
  std::uint64_t compute, wire;  // cycles: making the line, and sending it
};

// The smallest number of line buffers with which the wire never waits once it has begun, where it begins as soon as all
// buffers are full. A buffer is free again when its line has been sent. Nothing where only a buffer for every line
// would do.
std::optional<std::uint32_t> smallest_ring(const std::vector<LineTime>& lines);

// Cycles of a frame with so many buffers, from its first line's beginning to the last byte sent; the wire begins as
// soon as a line is there.
std::uint64_t frame_time(const std::vector<LineTime>& lines, std::uint32_t buffers);

}  // namespace spanline::host
