#include "mcu/pool_watch.hpp"

#include <algorithm>

namespace spanline::host {
namespace {

// "Pool<spanline::EdgeBlock, 24>": 24.
std::uint32_t capacity_of(const std::string& type) {
  const std::size_t comma = type.rfind(',');
  return comma == std::string::npos ? 0 : static_cast<std::uint32_t>(std::stoul(type.substr(comma + 1)));
}

}  // namespace

PoolWatch::PoolWatch(const Image& image, const DebugInfo& debug) {
  const std::optional<DebugInfo::Structure> memory = debug.structure("FrameMemory<");
  if (!memory) return;
  const auto object = std::find_if(image.objects().begin(), image.objects().end(), [&](const Image::Symbol& symbol) {
    return symbol.size == memory->bytes && symbol.name.find("memory") != std::string::npos;
  });
  if (object == image.objects().end()) return;
  base_ = object->address;
  bytes_ = memory->bytes;
  for (const DebugInfo::Member& member : memory->members) {
    const std::uint32_t capacity = member.type.rfind("Pool<", 0) == 0 ? capacity_of(member.type) : 0;
    if (capacity == 0) continue;
    const std::uint32_t bytes = member.bytes / member.elements;
    for (std::uint32_t i = 0; i < member.elements; ++i) {
      ranges_.push_back({base_ + member.offset + i * bytes, bytes, pools_.size()});
    }
    pools_.push_back({member.name.substr(0, member.name.find_last_not_of('_') + 1), bytes / (capacity + 1), capacity});
  }
}

void PoolWatch::note(std::uint32_t address) {
  for (const Range& range : ranges_) {
    if (address - range.base >= range.bytes) continue;
    PoolUse& pool = pools_[range.pool];
    pool.used = std::max(pool.used, (address - range.base) / pool.block_bytes);
    return;
  }
}

void PoolWatch::clear() {
  for (PoolUse& pool : pools_) pool.used = 0;
}

}  // namespace spanline::host
