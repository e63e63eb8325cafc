// The container that a Pico takes, and the checksum of its second-stage boot.
#include "uf2.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

namespace spanline::host {
namespace {

std::uint32_t word(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  return bytes[at] | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
         std::uint32_t{bytes[at + 3]} << 24;
}

TEST(BootChecksum, IsTheCatalogueValueOfTheCheckString) {
  const char* check = "123456789";
  EXPECT_EQ(boot_checksum(reinterpret_cast<const std::uint8_t*>(check), std::strlen(check)), 0x0376E6E7u);
}

TEST(BootError, NamesTheChecksumThatIsNeeded) {
  std::vector<std::uint8_t> image(300, 7);
  EXPECT_NE(boot_error(image).find("has to be 0x"), std::string::npos);
  const std::uint32_t sum = boot_checksum(image.data(), 252);
  for (unsigned i = 0; i < 4; ++i) image[252 + i] = static_cast<std::uint8_t>(sum >> 8 * i);
  EXPECT_EQ(boot_error(image), "");
  image.resize(255);
  EXPECT_NE(boot_error(image), "");
}

TEST(Uf2, EveryBlockSaysWhereItBelongs) {
  std::vector<std::uint8_t> image(600);
  std::iota(image.begin(), image.end(), std::uint8_t{0});
  const std::vector<std::uint8_t> packed = to_uf2(image, kRp2040Flash, kRp2040Family);
  ASSERT_EQ(packed.size(), 3u * 512);
  for (std::uint32_t block = 0; block < 3; ++block) {
    const std::size_t at = block * 512;
    EXPECT_EQ(word(packed, at), 0x0A324655u);
    EXPECT_EQ(word(packed, at + 4), 0x9E5D5157u);
    EXPECT_EQ(word(packed, at + 8), 0x2000u);
    EXPECT_EQ(word(packed, at + 12), 0x10000000u + 256 * block);
    EXPECT_EQ(word(packed, at + 16), 256u);
    EXPECT_EQ(word(packed, at + 20), block);
    EXPECT_EQ(word(packed, at + 24), 3u);
    EXPECT_EQ(word(packed, at + 28), kRp2040Family);
    EXPECT_EQ(word(packed, at + 508), 0x0AB16F30u);
    for (std::size_t i = 0; i < 256; ++i) {
      const std::size_t from = block * 256 + i;
      EXPECT_EQ(packed[at + 32 + i], from < image.size() ? image[from] : 0);
    }
  }
}

TEST(Uf2, NothingIsNoBlock) { EXPECT_TRUE(to_uf2({}, kRp2040Flash, kRp2040Family).empty()); }

}  // namespace
}  // namespace spanline::host
