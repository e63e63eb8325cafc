#include "sim/output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "assetc/input_error.hpp"

namespace spanline::host {
namespace fs = std::filesystem;

void write_file(const std::string& path, std::string_view bytes) {
  const std::string part = path + "." + std::to_string(getpid()) + ".part";
  const auto fail = [&](const std::string& why) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw InputError(path, "cannot be written: " + why);
  };
  if (fs::is_directory(path)) fail("is a directory");
  errno = 0;
  {
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    if (!out) fail(std::strerror(errno));
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) fail(std::strerror(errno));
  }
  std::error_code error;
  fs::rename(part, path, error);
  if (error) fail(error.message());
}

std::string numbered_path(const std::string& path, std::int64_t frame, std::int64_t last) {
  const fs::path whole(path);
  const std::size_t width = std::max<std::size_t>(4, std::to_string(last).size());
  std::string digits = std::to_string(frame);
  digits.insert(0, width - std::min(width, digits.size()), '0');
  const fs::path name = whole.stem().string() + "-" + digits + whole.extension().string();
  return (whole.parent_path() / name).string();
}

bool file_exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

}  // namespace spanline::host
