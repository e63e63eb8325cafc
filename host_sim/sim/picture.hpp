// Pictures as a person sees them, and what the engine's lines decode to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/pixel_format.hpp"

namespace spanline::host {

// Three bytes a pixel: red, green, blue; lines from the top.
struct Picture {
  std::uint16_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  Picture() = default;
  Picture(std::uint16_t w, std::uint16_t h) : width(w), height(h), rgb(std::size_t{3} * w * h) {}
};

// Decodes one line in wire order. RGB565 expands by bit replication, grey level i of 16 is 17 * i, a set bit is white.
void decode_line(PixelFormat format, const std::uint8_t* wire, std::uint16_t width, std::uint8_t* rgb);

// Binary PPM (P6) of the picture.
std::string encode_ppm(const Picture& picture);

// Binary PGM (P5) of width * height 16-bit values, big-endian as the format says.
std::string encode_pgm16(std::uint16_t width, std::uint16_t height, const std::vector<std::uint16_t>& values);

// True where this build has libpng. Without it the two functions below throw a UsageError that says so.
bool png_available();
std::string encode_png(const Picture& picture);

// The PNG file as 8-bit RGB. Throws InputError.
Picture read_png(const std::string& path);

// Writes .png or .ppm by the name's ending.
void write_picture(const std::string& path, const Picture& picture);

// Throws UsageError unless write_picture can write a file of this name.
void check_picture_path(const std::string& path);

}  // namespace spanline::host
