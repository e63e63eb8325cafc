// The loop table of the cycle rules, to the cycle: what a turn costs on each core.
#include <gtest/gtest.h>

#include <ostream>

#include "mcu/machine.hpp"
#include "mcu/tiny_elf.hpp"

namespace spanline::host {
namespace {

constexpr unsigned kNone = 0;  // the core lacks the instruction

struct Row {
  const char* name;
  std::vector<std::uint16_t> code;  // behind the preamble, to a BKPT
  unsigned m0, m0plus, m3, m4;      // cycles a turn
};

// Names the row in a test's name.
void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }

// r7 counts the turns; r0 and sp point into RAM, r1 is 4.
std::vector<std::uint16_t> preamble(unsigned turns) {
  return {static_cast<std::uint16_t>(0x2700 | turns),  // movs r7, #turns
          0x2020,
          0x0600,
          0x3040,  // movs r0, #0x20; lsls r0, r0, #24; adds r0, #64
          0x4685,
          0x2104};  // mov sp, r0; movs r1, #4
}

// Assembled by arm-none-eabi-as; every loop is aligned to 4 and ends with subs r7, #1; bne.
const std::vector<Row> kRows = {
    {"empty", {0x3F01, 0xD1FD, 0xBE00, 0x46C0}, 4, 3, 3, 3},
    {"empty, subs.w at an odd halfword", {0xBF00, 0xF1B7, 0x0701, 0xD1FC, 0xBE00, 0xBF00}, kNone, kNone, 4, 4},
    {"three independent LDR", {0x6801, 0x6842, 0x6883, 0x3F01, 0xD1FA, 0xBE00}, 10, 9, 7, 7},
    {"adds; ldr from that address", {0x1D01, 0x680A, 0x3F01, 0xD1FB, 0xBE00, 0x46C0}, 7, 6, 7, 7},
    {"str; ldr, same memory", {0x6001, 0x6842, 0x3F01, 0xD1FB, 0xBE00, 0x46C0}, 8, 7, 7, 7},
    {"str; str", {0x6001, 0x6042, 0x3F01, 0xD1FB, 0xBE00, 0x46C0}, 8, 7, 5, 5},
    {"bl f, f: bx lr", {0xF000, 0xF804, 0x3F01, 0xD1FB, 0xBE00, 0x46C0, 0x4770, 0x46C0}, 11, 8, 7, 7},
    {"push 4; pop 4", {0xB41E, 0xBC1E, 0x3F01, 0xD1FB, 0xBE00, 0x46C0}, 14, 13, 13, 13},
    {"bl f, f: push {r4,lr}; pop {r4,pc}",
     {0xF000, 0xF804, 0x3F01, 0xD1FB, 0xBE00, 0x46C0, 0xB510, 0xBD10},
     17,
     14,
     14,
     14},
    {"mla", {0xFB01, 0x4302, 0x3F01, 0xD1FB, 0xBE00, 0xBF00}, kNone, kNone, 5, 4},
    {"umull 1x1", {0x2101, 0x2201, 0xFBA1, 0x3402, 0x3F01, 0xD1FB, 0xBE00, 0xBF00}, kNone, kNone, 6, 4},
    {"umull -1x-1",
     {0xF06F, 0x0100, 0xF06F, 0x0200, 0xFBA1, 0x3402, 0x3F01, 0xD1FB, 0xBE00, 0xBF00},
     kNone,
     kNone,
     8,
     4},
    {"udiv 1000/7",
     {0xF44F, 0x717A, 0x2207, 0xBF00, 0xFBB1, 0xF3F2, 0x3F01, 0xD1FB, 0xBE00, 0xBF00},
     kNone,
     kNone,
     9,
     9},
    {"udiv 0xFFFFFFFF/1",
     {0xF06F, 0x0100, 0x2201, 0xBF00, 0xFBB1, 0xF3F2, 0x3F01, 0xD1FB, 0xBE00, 0xBF00},
     kNone,
     kNone,
     15,
     15},
    {"cbz taken", {0x2100, 0xBF00, 0xB101, 0xBF00, 0x3F01, 0xD1FB, 0xBE00, 0xBF00}, kNone, kNone, 6, 6},
    {"cmp; it; moveq, skipped", {0x2100, 0xBF00, 0x2901, 0xBF08, 0x461A, 0x3F01, 0xD1FA, 0xBE00}, kNone, kNone, 5, 5},
    {"cmp; it; moveq, executed", {0x2101, 0xBF00, 0x2901, 0xBF08, 0x461A, 0x3F01, 0xD1FA, 0xBE00}, kNone, kNone, 5, 5},
};

std::uint64_t cycles(const Row& row, const char* board, unsigned turns) {
  TinyElf elf;
  elf.code = preamble(turns);
  elf.code.insert(elf.code.end(), row.code.begin(), row.code.end());
  const Image image(write_tiny_elf(elf, std::string("loop-") + board + ".elf"));
  return run_image(image, board_named(board), {}).total.cycles;
}

class LoopTable : public testing::TestWithParam<Row> {};

TEST_P(LoopTable, HoldsToTheCycle) {
  const Row& row = GetParam();
  const auto check = [&](const char* board, unsigned expected) {
    if (expected == kNone) return;
    EXPECT_EQ(cycles(row, board, 200) - cycles(row, board, 100), 100u * expected) << row.name << " on " << board;
  };
  check("cortex-m0", row.m0);
  check("cortex-m0plus", row.m0plus);
  check("cortex-m3", row.m3);
  check("cortex-m4", row.m4);
}

INSTANTIATE_TEST_SUITE_P(Rows, LoopTable, testing::ValuesIn(kRows));

}  // namespace
}  // namespace spanline::host
