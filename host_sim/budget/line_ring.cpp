#include "budget/line_ring.hpp"

#include <algorithm>

namespace spanline::host {
namespace {

struct Outcome {
  std::uint64_t end = 0;
  bool starved = false;
};

// Line k may begin when line k - buffers has been sent; it is sent when it is done and line k - 1 has been sent, the
// first not before `first_ready` lines are done.
Outcome play(const std::vector<LineTime>& lines, std::size_t buffers, std::size_t first_ready) {
  Outcome outcome;
  std::vector<std::uint64_t> sent(lines.size());
  std::uint64_t done = 0, first = 0;
  for (std::size_t k = 0; k < first_ready; ++k) first += lines[k].compute;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    done = std::max(done, k >= buffers ? sent[k - buffers] : 0) + lines[k].compute;
    const std::uint64_t free = k == 0 ? first : sent[k - 1];
    if (k != 0 && done > free) outcome.starved = true;
    sent[k] = std::max(done, free) + lines[k].wire;
  }
  outcome.end = lines.empty() ? 0 : sent.back();
  return outcome;
}

}  // namespace

std::optional<std::uint32_t> smallest_ring(const std::vector<LineTime>& lines) {
  for (std::size_t buffers = 1; buffers < lines.size(); ++buffers) {
    if (!play(lines, buffers, buffers).starved) return static_cast<std::uint32_t>(buffers);
  }
  return std::nullopt;
}

std::uint64_t frame_time(const std::vector<LineTime>& lines, std::uint32_t buffers) {
  return play(lines, buffers, std::min<std::size_t>(1, lines.size())).end;
}

}  // namespace spanline::host
