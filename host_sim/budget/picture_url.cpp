#include "budget/picture_url.hpp"

namespace spanline::host {
namespace {

void put(std::string& bytes, std::uint32_t value, unsigned count) {
  for (; count != 0; --count, value >>= 8) bytes += static_cast<char>(value & 0xFF);
}

// Rows from the bottom up, blue first, each to a multiple of four bytes.
std::string bmp(const Picture& picture) {
  constexpr std::uint32_t kFileHeader = 14, kInfoHeader = 40, kBits = 24;
  const std::uint32_t row = (3u * picture.width + 3) / 4 * 4, pixels = row * picture.height;
  std::string bytes = "BM";
  put(bytes, kFileHeader + kInfoHeader + pixels, 4);
  put(bytes, 0, 4);
  put(bytes, kFileHeader + kInfoHeader, 4);
  put(bytes, kInfoHeader, 4);
  put(bytes, picture.width, 4);
  put(bytes, picture.height, 4);
  put(bytes, 1, 2);
  put(bytes, kBits, 2);
  bytes.append(24, '\0');  // not packed, no palette
  for (std::size_t y = picture.height; y-- != 0;) {
    const std::uint8_t* const rgb = &picture.rgb[y * 3 * picture.width];
    for (std::size_t x = 0; x < picture.width; ++x) {
      for (std::size_t channel = 3; channel-- != 0;) bytes += static_cast<char>(rgb[3 * x + channel]);
    }
    bytes.append(row - 3u * picture.width, '\0');
  }
  return bytes;
}

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      group = group << 8 | (k < bytes.size() ? static_cast<std::uint8_t>(bytes[k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

}  // namespace

std::string picture_url(const Picture& picture) { return "data:image/bmp;base64," + base64(bmp(picture)); }

}  // namespace spanline::host
