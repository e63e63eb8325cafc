#include "sim/picture.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "sim/output_file.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

constexpr std::uint8_t expand5(unsigned v) { return static_cast<std::uint8_t>(v << 3 | v >> 2); }
constexpr std::uint8_t expand6(unsigned v) { return static_cast<std::uint8_t>(v << 2 | v >> 4); }

void put_grey(std::uint8_t level, std::uint8_t* rgb) { std::fill(rgb, rgb + 3, level); }

void decode_rgb565(const std::uint8_t* wire, std::uint16_t width, std::uint8_t* rgb) {
  for (unsigned x = 0; x < width; ++x, rgb += 3) {
    const unsigned pixel = static_cast<unsigned>(wire[2 * x]) << 8 | wire[2 * x + 1];
    rgb[0] = expand5(pixel >> 11);
    rgb[1] = expand6(pixel >> 5 & 63);
    rgb[2] = expand5(pixel & 31);
  }
}

std::string pnm_header(const char* magic, std::uint16_t width, std::uint16_t height, int largest) {
  return std::string(magic) + "\n" + std::to_string(width) + " " + std::to_string(height) + "\n" +
         std::to_string(largest) + "\n";
}

}  // namespace

void decode_line(PixelFormat format, const std::uint8_t* wire, std::uint16_t width, std::uint8_t* rgb) {
  if (format == PixelFormat::rgb565) return decode_rgb565(wire, width, rgb);
  for (unsigned x = 0; x < width; ++x, rgb += 3) {
    switch (format) {
      case PixelFormat::grey8:
        put_grey(wire[x], rgb);
        break;
      case PixelFormat::grey4:
        put_grey(static_cast<std::uint8_t>(17 * (x % 2 == 0 ? wire[x / 2] >> 4 : wire[x / 2] & 15)), rgb);
        break;
      default:
        put_grey((wire[x / 8] >> (7 - x % 8) & 1) != 0 ? 255 : 0, rgb);
    }
  }
}

std::string encode_ppm(const Picture& picture) {
  std::string bytes = pnm_header("P6", picture.width, picture.height, 255);
  bytes.append(picture.rgb.begin(), picture.rgb.end());
  return bytes;
}

std::string encode_pgm16(std::uint16_t width, std::uint16_t height, const std::vector<std::uint16_t>& values) {
  std::string bytes = pnm_header("P5", width, height, 65535);
  for (const std::uint16_t value : values) {
    bytes.push_back(static_cast<char>(value >> 8));
    bytes.push_back(static_cast<char>(value & 255));
  }
  return bytes;
}

void write_picture(const std::string& path, const Picture& picture) {
  write_file(path, lower_extension(path) == ".png" ? encode_png(picture) : encode_ppm(picture));
}

void check_picture_path(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension != ".png" && extension != ".ppm") throw UsageError(path + ": must end in .png or .ppm");
  if (extension == ".png" && !png_available()) {
    throw UsageError(path + ": this build has no libpng; use a name that ends in .ppm");
  }
}

}  // namespace spanline::host
