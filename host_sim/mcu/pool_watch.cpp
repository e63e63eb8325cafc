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
  add_pools(*memory, base_, debug);
}

// A structure's pools, and those of the structures in it.
void PoolWatch::add_pools(const DebugInfo::Structure& structure, std::uint32_t base, const DebugInfo& debug) {
  for (const DebugInfo::Member& member : structure.members) {
    const std::uint32_t capacity = member.type.rfind("Pool<", 0) == 0 ? capacity_of(member.type) : 0;
    const std::uint32_t bytes = member.bytes / member.elements, at = base + member.offset;
    if (capacity == 0) {
      const std::optional<DebugInfo::Structure> inner =
          member.type.find("Pool") == std::string::npos ? std::nullopt : debug.structure(member.type);
      if (inner) add_pools(*inner, at, debug);
      continue;
    }
    for (std::uint32_t i = 0; i < member.elements; ++i) ranges_.push_back({at + i * bytes, bytes, pools_.size()});
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
