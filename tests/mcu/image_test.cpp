// Files that are no image of a Cortex-M: each is refused in one line that says why.
#include "mcu/image.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "assetc/input_error.hpp"
#include "mcu/tiny_elf.hpp"

namespace spanline::host {
namespace {

std::string refusal(const std::string& path) {
  try {
    const Image image(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

std::string file_of(const std::string& name, const std::string& bytes) {
  std::string path = temporary_file(name);
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

std::string bytes_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(Image, KnowsItsFunctions) {
  TinyElf elf;
  elf.code = {0xBF00, 0xBF00, 0x4770, 0xBE00};
  elf.symbols = {{"reset", 0x41, 4}, {"_ZN8spanline5helpsEi", 0x45, 2}, {"table", 0x46, 2, false}};
  const Image image(write_tiny_elf(elf, "functions.elf"));
  ASSERT_EQ(image.functions().size(), 2u);
  EXPECT_EQ(image.name_at(0x42), "reset");
  EXPECT_EQ(image.name_at(0x44), "spanline::helps(int)");
  EXPECT_EQ(image.name_at(0x46), "0x00000046");
  EXPECT_EQ(image.address_of("spanline::helps"), 0x44u);
  EXPECT_EQ(image.address_of("_ZN8spanline5helpsEi"), 0x44u);
  EXPECT_EQ(image.address_of("table"), 0x46u);
  EXPECT_THROW(image.address_of("nobody"), InputError);
}

TEST(Image, KnowsNamesAsTheyAreSpoken) {
  TinyElf elf;
  elf.code = {0xBF00, 0x4770, 0x4770, 0x4770, 0x4770, 0xBE00};
  elf.symbols = {{"_ZN3app6Filter4stepEi.isra.0", 0x41, 2}, {"_ZN3app5twiceIiEET_S1_", 0x43, 2},
                 {"_ZN3app12_GLOBAL__N_14hideEv", 0x45, 2}, {"_ZNK3app6FiltereqEi", 0x47, 2},
                 {"_ZN3app4callEPFvvE.cold", 0x4B, 2},      {"_ZN3app4callEPFvvE", 0x49, 2}};
  const Image image(write_tiny_elf(elf, "names.elf"));
  EXPECT_EQ(image.address_of("app::Filter::step"), 0x40u);
  EXPECT_EQ(image.address_of("app::twice<int>"), 0x42u);
  EXPECT_EQ(image.address_of("app::(anonymous namespace)::hide"), 0x44u);
  EXPECT_EQ(image.address_of("app::Filter::operator=="), 0x46u);
  EXPECT_EQ(image.address_of("app::call"), 0x48u);  // not the part that is seldom reached
  EXPECT_TRUE(image.defines("app::Filter::step"));
}

TEST(Image, RefusesWhatIsNoImage) {
  EXPECT_NE(refusal(file_of("text.elf", "hello")).find("not an ELF file"), std::string::npos);
  EXPECT_NE(refusal(file_of("empty.elf", "")).find("not an ELF file"), std::string::npos);
  TinyElf elf;
  elf.code = {0xBE00};
  elf.machine = 62;
  EXPECT_NE(refusal(write_tiny_elf(elf, "x86.elf")).find("machine is 62"), std::string::npos);
  elf.machine = 40;
  elf.symbols.clear();
  EXPECT_NE(refusal(write_tiny_elf(elf, "stripped.elf")).find("has no symbols"), std::string::npos);
  EXPECT_NE(refusal(temporary_file("nowhere.elf")), "none");
}

// Whatever was lost or flipped: an answer or a refusal, never a crash.
TEST(Image, SurvivesBrokenFiles) {
  TinyElf elf;
  elf.code = {0xBF00, 0x4770, 0xBE00, 0xBF00};
  const std::string whole = bytes_of(write_tiny_elf(elf, "whole.elf"));
  for (std::size_t size = 0; size < whole.size(); ++size) refusal(file_of("broken.elf", whole.substr(0, size)));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char flip : {'\x80', '\x01', '\xff'}) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ flip);
      refusal(file_of("broken.elf", bytes));
    }
  }
}

}  // namespace
}  // namespace spanline::host
