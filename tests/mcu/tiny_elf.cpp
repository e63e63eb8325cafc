#include "mcu/tiny_elf.hpp"

#include <fstream>

#include "host/support.hpp"

namespace spanline::host {
namespace {

class Bytes {
 public:
  void half(std::uint32_t value) {
    text_.push_back(static_cast<char>(value));
    text_.push_back(static_cast<char>(value >> 8));
  }
  void word(std::uint32_t value) {
    half(value);
    half(value >> 16);
  }
  void words(std::initializer_list<std::uint32_t> values) {
    for (const std::uint32_t value : values) word(value);
  }
  void append(const std::string& text) { text_ += text; }
  void pad_to(std::size_t size) { text_.resize(size); }
  const std::string& text() const { return text_; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(text_.size()); }

 private:
  std::string text_;
};

std::string memory_of(const TinyElf& elf) {
  Bytes memory;
  memory.words({elf.stack, elf.base + TinyElf::kCode + 1});
  memory.pad_to(TinyElf::kCode - 4);
  memory.word(elf.tick);
  for (const std::uint16_t half : elf.code) memory.half(half);
  while (memory.size() % 4 != 0) memory.half(0);
  return memory.text();
}

}  // namespace

std::string temporary_file(const std::string& name) {
  static const TemporaryFolder folder;
  return folder.file(name);
}

std::string write_tiny_elf(const TinyElf& elf, const std::string& name) {
  constexpr std::uint32_t kHeader = 52, kProgramHeader = 32, kLoad = 1, kReadExecute = 5;
  constexpr std::uint32_t kProgbits = 1, kSymtab = 2, kStrtab = 3, kAllocExecute = 6;
  const std::string memory = memory_of(elf);
  std::string strings(1, 0);
  Bytes symbols;
  symbols.words({0, 0, 0, 0});
  for (const TinySymbol& symbol : elf.symbols) {
    symbols.words({static_cast<std::uint32_t>(strings.size()), symbol.address, symbol.size});
    symbols.half(symbol.function ? 0x12 : 0x11);  // global, function or object
    symbols.half(1);
    strings += symbol.name + '\0';
  }
  const std::string section_names = std::string("\0.text\0.symtab\0.strtab\0", 23);
  const std::uint32_t text_at = kHeader + kProgramHeader;
  const auto length = static_cast<std::uint32_t>(memory.size());
  const std::uint32_t symbols_at = text_at + length, strings_at = symbols_at + symbols.size();
  const auto strings_length = static_cast<std::uint32_t>(strings.size());
  const std::uint32_t names_at = strings_at + strings_length;

  Bytes file;
  file.append(
      std::string("\x7f"
                  "ELF\1\1\1\0\0\0\0\0\0\0\0\0",
                  16));
  file.half(2);  // executable
  file.half(elf.machine);
  file.words({1, elf.base + TinyElf::kCode + 1, kHeader, names_at + 24, 0x0500'0200});
  for (const std::uint32_t half : {kHeader, kProgramHeader, 1u, 40u, 5u, 4u}) file.half(half);
  file.words({kLoad, text_at, elf.base, elf.base, length, length, kReadExecute, 4});
  file.append(memory + symbols.text() + strings + section_names);
  file.pad_to(names_at + 24);
  file.words({0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  file.words({1, kProgbits, kAllocExecute, elf.base, text_at, length, 0, 0, 4, 0});
  file.words({7, kSymtab, 0, 0, symbols_at, symbols.size(), 3, 1, 4, 16});
  file.words({15, kStrtab, 0, 0, strings_at, strings_length, 0, 0, 1, 0});
  file.words({15, kStrtab, 0, 0, names_at, 23, 0, 0, 1, 0});
  std::string path = temporary_file(name);
  std::ofstream(path, std::ios::binary) << file.text();
  return path;
}

}  // namespace spanline::host
