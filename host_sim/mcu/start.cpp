#include "assetc/input_error.hpp"
#include "mcu/machine.hpp"

namespace spanline::host {
namespace {

bool is_code(const Image& image, std::uint32_t address) {
  std::uint16_t halfword;
  return image.read(address, 2, &halfword);
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
  constexpr std::uint32_t kSecondStageBoot = 256;
  for (const std::uint32_t vectors : {lowest, lowest + kSecondStageBoot}) {
    std::uint32_t words[2];
    if (!image.read(vectors, sizeof words, words)) continue;
    const bool stack =
        (words[0] & 3) == 0 && board.memory_at(words[0] - 4) != nullptr && !board.memory_at(words[0] - 4)->flash;
    if (stack && (words[1] & 1) != 0 && is_code(image, words[1] & ~1u))
      return {words[0], words[1] & ~1u, vectors, true};
  }
  const BoardDescription::Memory& ram = board.memories.back();
  if (!is_code(image, image.entry())) {
    throw InputError(image.path(), "has neither a vector table at " + hex(lowest) + " nor code at its entry point " +
                                       hex(image.entry()));
  }
  return {ram.base + ram.size, image.entry(), lowest, false};
}

}  // namespace spanline::host
