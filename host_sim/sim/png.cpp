#include <png.h>

#include "assetc/input_error.hpp"
#include "sim/picture.hpp"

namespace spanline::host {
namespace {

// libpng's simplified interface keeps its errors in the image.
class PngImage {
 public:
  PngImage() { image_.version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(&image_); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  png_image* operator->() { return &image_; }
  png_image* get() { return &image_; }

 private:
  png_image image_{};
};

}  // namespace

bool png_available() { return true; }

std::string encode_png(const Picture& picture) {
  PngImage image;
  image->width = picture.width;
  image->height = picture.height;
  image->format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(*image.get());
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(image.get(), bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr) == 0) {
    throw InputError("PNG", image->message);
  }
  bytes.resize(size);
  return bytes;
}

Picture read_png(const std::string& path) {
  PngImage image;
  if (png_image_begin_read_from_file(image.get(), path.c_str()) == 0) throw InputError(path, image->message);
  if (image->width > UINT16_MAX || image->height > UINT16_MAX) throw InputError(path, "is larger than any screen");
  image->format = PNG_FORMAT_RGB;
  Picture picture(static_cast<std::uint16_t>(image->width), static_cast<std::uint16_t>(image->height));
  const png_color black{0, 0, 0};
  if (png_image_finish_read(image.get(), &black, picture.rgb.data(), 0, nullptr) == 0) {
    throw InputError(path, image->message);
  }
  return picture;
}

}  // namespace spanline::host
