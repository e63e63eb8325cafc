// uf2 IMAGE.bin OUT.uf2: packs an RP2040 image that begins with its second-stage boot, whose checksum must be right.
#include <cstdio>
#include <fstream>
#include <iterator>

#include "uf2.hpp"

int main(int argc, char** argv) {
  using namespace spanline::host;
  if (argc != 3) {
    std::fprintf(stderr, "usage: uf2 IMAGE.bin OUT.uf2\n");
    return 2;
  }
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<std::uint8_t> image{std::istreambuf_iterator<char>(in), {}};
  const std::string error = !in.good() && image.empty() ? "cannot be read" : boot_error(image);
  if (!error.empty()) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.c_str());
    return 1;
  }
  const std::vector<std::uint8_t> packed = to_uf2(image, kRp2040Flash, kRp2040Family);
  std::ofstream out(argv[2], std::ios::binary);
  out.write(reinterpret_cast<const char*>(packed.data()), static_cast<std::streamsize>(packed.size()));
  out.close();
  if (!out) {
    std::fprintf(stderr, "%s: cannot be written\n", argv[2]);
    std::remove(argv[2]);
    return 1;
  }
  return 0;
}
