#include "uf2.hpp"

#include <algorithm>
#include <cstdio>

namespace spanline::host {
namespace {

constexpr std::size_t kBoot = 256, kPayload = 256, kBlock = 512;

void put(std::vector<std::uint8_t>& out, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(word >> shift));
}

std::uint32_t word_at(const std::uint8_t* bytes) {
  return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
}

}  // namespace

std::uint32_t boot_checksum(const std::uint8_t* bytes, std::size_t count) {
  std::uint32_t sum = 0xFFFFFFFF;
  for (std::size_t i = 0; i < count; ++i) {
    sum ^= std::uint32_t{bytes[i]} << 24;
    for (int bit = 0; bit < 8; ++bit) sum = sum << 1 ^ (sum >> 31 ? 0x04C11DB7u : 0);
  }
  return sum;
}

std::string boot_error(const std::vector<std::uint8_t>& image) {
  if (image.size() < kBoot) return "shorter than the second-stage boot";
  const std::uint32_t wanted = boot_checksum(image.data(), kBoot - 4);
  if (word_at(&image[kBoot - 4]) == wanted) return {};
  char text[80];
  std::snprintf(text, sizeof text, "the second-stage boot's checksum has to be 0x%08x", static_cast<unsigned>(wanted));
  return text;
}

std::vector<std::uint8_t> to_uf2(const std::vector<std::uint8_t>& image, std::uint32_t address, std::uint32_t family) {
  constexpr std::uint32_t kFirstMagic = 0x0A324655, kSecondMagic = 0x9E5D5157, kLastMagic = 0x0AB16F30,
                          kHasFamily = 0x2000;
  const auto blocks = static_cast<std::uint32_t>((image.size() + kPayload - 1) / kPayload);
  std::vector<std::uint8_t> out;
  out.reserve(blocks * kBlock);
  for (std::uint32_t block = 0; block < blocks; ++block) {
    const std::size_t from = block * kPayload, count = std::min(kPayload, image.size() - from);
    for (const std::uint32_t word : {kFirstMagic, kSecondMagic, kHasFamily, static_cast<std::uint32_t>(address + from),
                                     static_cast<std::uint32_t>(kPayload), block, blocks, family}) {
      put(out, word);
    }
    out.insert(out.end(), image.begin() + static_cast<std::ptrdiff_t>(from),
               image.begin() + static_cast<std::ptrdiff_t>(from + count));
    out.resize((block + 1) * kBlock - 4);
    put(out, kLastMagic);
  }
  return out;
}

}  // namespace spanline::host
