#include "budget/memory_report.hpp"

#include <algorithm>

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
  for (const std::vector<Image::Symbol>* symbols : {&image.functions(), &image.objects()}) {
    for (const Image::Symbol& symbol : *symbols) {
      for (const Image::Section& section : image.sections()) {
        if (symbol.size == 0 || symbol.address - section.address >= section.size) continue;
        report.symbols.push_back(part_of(section, board, symbol.name, symbol.size));
        break;
      }
    }
  }
  std::stable_sort(report.symbols.begin(), report.symbols.end(),
                   [](const MemoryReport::Part& a, const MemoryReport::Part& b) {
                     return std::max(a.flash, a.ram) > std::max(b.flash, b.ram);
                   });
  return report;
}

}  // namespace spanline::host
