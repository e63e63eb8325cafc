#include "budget/memory_report.hpp"

#include <algorithm>
#include <map>

#include "mcu/debug_info.hpp"

namespace spanline::host {
namespace {

bool in_flash(const BoardDescription& board, std::uint32_t address) {
  const BoardDescription::Memory* const memory = board.memory_at(address);
  return memory != nullptr && memory->flash;
}

MemoryReport::Part part_of(const Image::Section& section, const BoardDescription& board, const std::string& name,
                           std::uint32_t size) {
  const bool flash = section.in_file && in_flash(board, section.load_address);
  return {name, flash ? size : 0, in_flash(board, section.address) ? 0 : size};
}

// "core/vsg", "hal", "scenes". What the compiler's libraries bring has no file of ours; scene tables are told by their
// namespace.
std::string room_of(const std::string& file, const std::string& symbol) {
  if (file.find("/scenes/") != std::string::npos || symbol.find("_scene::") != std::string::npos) return "scenes";
  if (file.empty() || file.find("libgcc") != std::string::npos) return "libraries";
  const std::size_t firmware = file.rfind("firmware/");
  if (firmware == std::string::npos) return "application";
  const std::string inside = file.substr(firmware + 9);
  const std::size_t first = inside.find('/'), second = inside.find('/', first + 1);
  return inside.rfind("core/", 0) == 0 ? inside.substr(0, second) : inside.substr(0, first);
}

void sort_by_size(std::vector<MemoryReport::Part>& parts) {
  std::stable_sort(parts.begin(), parts.end(), [](const MemoryReport::Part& a, const MemoryReport::Part& b) {
    return std::max(a.flash, a.ram) > std::max(b.flash, b.ram);
  });
}

}  // namespace

MemoryReport memory_report(const Image& image, const BoardDescription& board) {
  MemoryReport report;
  for (const BoardDescription::Memory& memory : board.memories) {
    (memory.flash ? report.flash_of_board : report.ram_of_board) += memory.size;
  }
  for (const Image::Section& section : image.sections()) {
    report.sections.push_back(part_of(section, board, section.name, section.size));
    report.flash += report.sections.back().flash;
    report.ram += report.sections.back().ram;
  }
  const DebugInfo debug(image.path());
  std::map<std::string, MemoryReport::Part> rooms;
  for (const std::vector<Image::Symbol>* symbols : {&image.functions(), &image.objects()}) {
    for (const Image::Symbol& symbol : *symbols) {
      for (const Image::Section& section : image.sections()) {
        if (symbol.size == 0 || symbol.address - section.address >= section.size) continue;
        const MemoryReport::Part part = part_of(section, board, symbol.name, symbol.size);
        report.symbols.push_back(part);
        MemoryReport::Part& room = rooms[room_of(debug.file_of(symbol.address), symbol.name)];
        room.flash += part.flash;
        room.ram += part.ram;
        break;
      }
    }
  }
  for (auto& [name, part] : rooms) report.rooms.push_back({name, part.flash, part.ram});
  sort_by_size(report.rooms);
  sort_by_size(report.symbols);
  return report;
}

}  // namespace spanline::host
