#include "emulator/screendump.hpp"

#include <algorithm>
#include <fstream>
#include <limits>

#include "assetc/input_error.hpp"

namespace spanline::host {

Picture read_ppm(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path, "cannot be opened");
  std::string magic;
  unsigned width = 0, height = 0, largest = 0;
  in >> magic >> width >> height >> largest;
  constexpr unsigned kMost = std::numeric_limits<std::uint16_t>::max();
  if (!in || magic != "P6" || largest != 255 || width == 0 || height == 0 || width > kMost || height > kMost) {
    throw InputError(path, "is no binary PPM with 8-bit samples");
  }
  in.get();  // the one white space before the samples
  Picture picture(static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height));
  in.read(reinterpret_cast<char*>(picture.rgb.data()), static_cast<std::streamsize>(picture.rgb.size()));
  if (!in) throw InputError(path, "ends too early");
  return picture;
}

Picture shrink(const Picture& dump, std::uint16_t scale, const std::string& path) {
  if (dump.width % scale != 0 || dump.height % scale != 0) throw InputError(path, "is no multiple of the panel");
  Picture panel(static_cast<std::uint16_t>(dump.width / scale), static_cast<std::uint16_t>(dump.height / scale));
  const auto pixel = [](auto& picture, std::size_t x, std::size_t y) {
    return &picture.rgb[3 * (y * picture.width + x)];
  };
  for (std::size_t y = 0; y < dump.height; ++y) {
    for (std::size_t x = 0; x < dump.width; ++x) {
      const std::uint8_t* from = pixel(dump, x, y);
      std::uint8_t* to = pixel(panel, x / scale, y / scale);
      if (x % scale == 0 && y % scale == 0) {
        std::copy(from, from + 3, to);
      } else if (!std::equal(from, from + 3, to)) {
        throw InputError(path, "has two colours in one pixel of the panel");
      }
    }
  }
  return panel;
}

}  // namespace spanline::host
