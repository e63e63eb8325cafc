// UF2, the format that the RP2040's boot ROM takes as a file: blocks of 512 bytes, each with 256 of the image and its
// address.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace spanline::host {

inline constexpr std::uint32_t kRp2040Family = 0xE48BFF56;
inline constexpr std::uint32_t kRp2040Flash = 0x10000000;

// CRC-32/MPEG-2 (polynomial 04C11DB7, from all ones, most significant bit first, nothing inverted), as the boot ROM
// computes it.
std::uint32_t boot_checksum(const std::uint8_t* bytes, std::size_t count);

// What is wrong with the second-stage boot at the beginning of an image: empty, or one line with the checksum that it
// needs.
std::string boot_error(const std::vector<std::uint8_t>& image);

// The image, meant for `address`, as UF2; the last block is filled up with zeros.
std::vector<std::uint8_t> to_uf2(const std::vector<std::uint8_t>& image, std::uint32_t address, std::uint32_t family);

}  // namespace spanline::host
