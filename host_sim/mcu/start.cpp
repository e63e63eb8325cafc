#include "assetc/input_error.hpp"
#include "mcu/machine.hpp"

namespace spanline::host {
namespace {

bool is_code(const Image& image, std::uint32_t address) {
  std::uint16_t halfword;
  return image.read(address, 2, &halfword);
}

// CRC-32/MPEG-2, as the boot ROM of the RP2040 computes it.
std::uint32_t checksum(const std::uint8_t* bytes, std::size_t count) {
  std::uint32_t crc = UINT32_MAX;
  for (std::size_t i = 0; i < count; ++i) {
    crc ^= std::uint32_t{bytes[i]} << 24;
    for (int bit = 0; bit < 8; ++bit) crc = crc << 1 ^ ((crc & 1u << 31) != 0 ? 0x04C1'1DB7u : 0u);
  }
  return crc;
}

// The second-stage boot at `address`, 0 where the board has no boot ROM that would run it.
std::uint32_t boot_of(const Image& image, const BoardDescription& board, std::uint32_t address) {
  if (board.family != BoardDescription::Family::rp2040) return 0;
  std::uint8_t boot[kSecondStageBoot];
  std::uint32_t expected = 0;
  image.read(address, sizeof boot, boot);
  image.read(address + kSecondStageBoot - 4, 4, &expected);
  if (checksum(boot, kSecondStageBoot - 4) != expected) {
    throw InputError(image.path(), "has a second-stage boot with a wrong checksum: the boot ROM would not run it");
  }
  return address;
}

}  // namespace

StartState start_of(const Image& image, const BoardDescription& board) {
  std::uint32_t lowest = UINT32_MAX;
  for (const Image::Segment& segment : image.segments()) {
    const auto size = static_cast<std::uint32_t>(segment.bytes.size());
    if (!board.holds(segment.load_address, size)) {
      throw InputError(image.path(), "is for another board: " + std::to_string(size) + " bytes at " +
                                         hex(segment.load_address) + " are in no memory of " + board.name);
    }
    lowest = segment.load_address < lowest ? segment.load_address : lowest;
  }
  for (const std::uint32_t vectors : {lowest, lowest + kSecondStageBoot}) {
    std::uint32_t words[2];
    if (!image.read(vectors, sizeof words, words)) continue;
    const bool stack =
        (words[0] & 3) == 0 && board.memory_at(words[0] - 4) != nullptr && !board.memory_at(words[0] - 4)->flash;
    if (stack && (words[1] & 1) != 0 && is_code(image, words[1] & ~1u))
      return {words[0], words[1] & ~1u, vectors, true, vectors == lowest ? 0 : boot_of(image, board, lowest)};
  }
  const BoardDescription::Memory& ram = board.memories.back();
  if (!is_code(image, image.entry())) {
    throw InputError(image.path(), "has neither a vector table at " + hex(lowest) + " nor code at its entry point " +
                                       hex(image.entry()));
  }
  return {ram.base + ram.size, image.entry(), lowest, false};
}

}  // namespace spanline::host
