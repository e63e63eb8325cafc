#include "mcu/memory_map.hpp"

#include <unicorn/unicorn.h>

namespace spanline::host {

void MemoryMap::map_memories(const BoardDescription& board, const Image& image) {
  for (const BoardDescription::Memory& memory : board.memories) {
    const std::uint32_t rights = memory.flash ? UC_PROT_READ | UC_PROT_EXEC : UC_PROT_ALL;
    uc_mem_map(core_.engine(), memory.base, memory.size, rights);
  }
  for (const Image::Segment& segment : image.segments()) {
    core_.write(segment.load_address, static_cast<std::uint32_t>(segment.bytes.size()), segment.bytes.data());
  }
}

void MemoryMap::map_registers(std::uint32_t base, std::uint32_t bytes) {
  const auto read = [](uc_engine*, std::uint64_t offset, unsigned size, void* data) -> std::uint64_t {
    const Window& window = *static_cast<const Window*>(data);
    return window.registers->read_register(window.base + static_cast<std::uint32_t>(offset), size);
  };
  const auto write = [](uc_engine*, std::uint64_t offset, unsigned size, std::uint64_t value, void* data) {
    const Window& window = *static_cast<const Window*>(data);
    window.registers->write_register(window.base + static_cast<std::uint32_t>(offset), size,
                                     static_cast<std::uint32_t>(value));
  };
  windows_.push_back({&registers_, base});
  uc_mmio_map(core_.engine(), base, bytes, read, &windows_.back(), write, &windows_.back());
}

}  // namespace spanline::host
